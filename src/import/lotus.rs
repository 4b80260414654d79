//! Files of Lotus Suspension Analysis (SHARK): `.shk`, and tables of numbered points as its reports
//! have them.

use super::options::Options;
use super::points::{Head, Row, suspension};
use super::{ImportError, Imported, LeftOut, Mistakes, Source};
use crate::model::{Axes, Axle, LengthUnit};

/// The points of template type 1, a double wishbone with the damper on the lower wishbone, by their
/// numbers.
const TYPE_1: &[(u32, &str)] = &[
    (1, "lca_front"),
    (2, "lca_rear"),
    (3, "lca_outer"),
    (5, "uca_front"),
    (6, "uca_rear"),
    (7, "uca_outer"),
    (8, "damper_lower"),
    (9, "damper_upper"),
    (11, "tierod_outer"),
    (12, "tierod_inner"),
    (16, "spring_upper"),
    (17, "spring_lower"),
    (18, "wheel_spindle"),
    (19, "wheel_center"),
];

/// The words that start a block of a `.shk` file.
const BLOCKS: &[&str] = &[
    "VERSION",
    "PARAMETERS",
    "TEMP_GRAPHICS",
    "TEMP_SETTINGS",
    "FRONT SUSPENSION",
    "REAR SUSPENSION",
    "TOLERANCES",
    "TITLES",
    "TYRE",
    "ROLL SOLUTION",
    "GROUPS",
    "COMPLIANCE",
    "MODAL",
];

/// Whether a text without a telling name is one of Lotus.
pub(super) fn is_lotus(text: &str) -> bool {
    let settings = text.lines().any(|line| line.trim_end() == "TEMP_SETTINGS");
    settings || text.lines().take(2000).filter(|line| numbered(line).is_some()).count() >= 8
}

pub(super) fn import(source: Source, options: &Options) -> Result<Imported, ImportError> {
    let mut mistakes = Mistakes::new(source.name, source.text);
    let lines: Vec<&str> = source.text.lines().collect();
    let shark = lines.iter().any(|line| line.trim_end() == "TEMP_SETTINGS");
    let (rows, radius, left_out) = if shark {
        let shark = Shark { lines: &lines, source };
        shark.read(options)?
    } else {
        let (rows, left_out) = table(&lines, &mut mistakes);
        (rows, None, left_out)
    };
    mistakes.finish()?;
    if rows.is_empty() {
        return Err(source.fault(
            "the file has no points that can be read",
            "rows are such as `1 Lower wishbone front pivot -110.0 257.0 69.0`",
        ));
    }
    let axes_assumed = options.axes.is_none();
    let head = Head {
        architecture: Some("double-wishbone".to_owned()),
        length: Some(LengthUnit::Millimetre),
        axes: Some(Axes::Adams),
        radius,
        format: if shark { "Lotus SHARK" } else { "a Lotus table of points" },
        ..Head::default()
    };
    let mut imported = suspension(source, &head, rows, options)?;
    if axes_assumed {
        imported.assumed.push(
            "the axes are those that Lotus starts with, x rearward, y right, z up; if not, import with --axes"
                .to_owned(),
        );
    }
    imported.left_out.extend(left_out);
    imported.left_out.sort();
    Ok(imported)
}

/// A row of a table: number, name and coordinates.
fn numbered(line: &str) -> Option<(u32, String, [f64; 3])> {
    let words: Vec<&str> =
        line.split([' ', '\t', ',', ';']).filter(|word| !word.is_empty()).collect();
    let (rest, coordinates) = words.split_last_chunk::<3>()?;
    let mut position = [0.0; 3];
    for (place, word) in position.iter_mut().zip(coordinates) {
        *place = word.parse().ok().filter(|number: &f64| number.is_finite())?;
    }
    let rest = match rest {
        [first, rest @ ..] if first.eq_ignore_ascii_case("point") => rest,
        rest => rest,
    };
    let (first, name) = rest.split_first()?;
    let number = first.trim_matches(['(', ')', ':', '.']).parse().ok()?;
    let name = name.join(" ");
    Some((number, name.trim_matches([':', '-', ' ']).to_owned(), position))
}

/// The numbered rows of a report. Other lines are headings and text, of which those with numbers are
/// listed.
fn table(lines: &[&str], mistakes: &mut Mistakes) -> (Vec<Row>, Vec<LeftOut>) {
    let (mut rows, mut left_out) = (vec![], vec![]);
    for (index, text) in lines.iter().enumerate() {
        let line = index + 1;
        let Some((number, name, position)) = numbered(text) else {
            if text.bytes().any(|byte| byte.is_ascii_digit()) && !text.trim_start().starts_with('#')
            {
                let why = "no row of number, name and three coordinates".to_owned();
                left_out.push(LeftOut { line, what: format!("`{}`", text.trim()), why });
            }
            continue;
        };
        let by_number = TYPE_1.iter().find(|(known, _)| *known == number).map(|(_, name)| *name);
        let called = match (name.is_empty(), by_number) {
            (false, _) => name,
            (true, Some(name)) => name.to_owned(),
            (true, None) => {
                let help = "write its name behind the number: `20 Rocker axis -10.0 552.0 115.0`";
                mistakes.note(line, format!("template type 1 has no point {number}"), help);
                continue;
            }
        };
        rows.push(Row { line, called, position });
    }
    (rows, left_out)
}

/// The points, the rolling radius of the tyre, and what is left out.
type Found = (Vec<Row>, Option<f64>, Vec<LeftOut>);

/// A `.shk` file.
struct Shark<'a> {
    lines: &'a [&'a str],
    source: Source<'a>,
}

impl Shark<'_> {
    fn read(&self, options: &Options) -> Result<Found, ImportError> {
        let names = self.names()?;
        let (slot, other) = self.slot(options)?;
        let first = slot + 2;
        let mut rows = vec![];
        for (index, called) in names.into_iter().enumerate() {
            let position = self.numbers::<3>(first + index, "the coordinates of a point")?;
            rows.push(Row { line: first + index + 1, called, position });
        }
        let [radius] = self.numbers::<1>(first + rows.len(), "the rolling radius of the tyre")?;
        let mut left_out = vec![];
        for (index, text) in self.lines.iter().enumerate() {
            let word = text.trim_end();
            let taken =
                index == slot || ["VERSION", "TEMP_SETTINGS", "TEMP_GRAPHICS"].contains(&word);
            if BLOCKS.contains(&word) && !taken {
                let why = match Some(index) == other {
                    true => "it is the other axle; import that one with --axle",
                    false => "settings of Lotus",
                };
                left_out.push(LeftOut {
                    line: index + 1,
                    what: format!("`{word}`"),
                    why: why.to_owned(),
                });
            }
        }
        Ok((rows, Some(radius), left_out))
    }

    /// The names of the points, in the order of the coordinates.
    fn names(&self) -> Result<Vec<String>, ImportError> {
        let settings =
            self.lines.iter().position(|line| line.trim_end() == "TEMP_SETTINGS").unwrap_or(0);
        let [parts, points] =
            self.numbers::<2>(settings + 3, "the numbers of parts and of points")?;
        let most = self.lines.len() as f64;
        if !(0.0..=most).contains(&parts) || !(1.0..=most).contains(&points) {
            let what = "the file has fewer lines than it says that it has points";
            return Err(self.source.mistake(settings + 4, what, "save it anew from Lotus"));
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        // They are at most the lines.
        let (parts, points) = (parts as usize, points as usize);
        let first = settings + 4 + parts;
        let name = |index: usize| {
            let line = first + 9 * index;
            let name = self.lines.get(line).map(|name| name.trim()).filter(|name| !name.is_empty());
            name.map(str::to_owned).ok_or_else(|| {
                self.source.mistake(
                    line + 1,
                    "here the name of a point should stand",
                    "save it anew from Lotus",
                )
            })
        };
        (0..points).map(name).collect()
    }

    /// The line of the geometry to take, and that of the other axle.
    fn slot(&self, options: &Options) -> Result<(usize, Option<usize>), ImportError> {
        let find = |word: &str| self.lines.iter().position(|line| line.trim_end() == word);
        match (find("FRONT SUSPENSION"), find("REAR SUSPENSION"), options.axle) {
            (Some(front), rear, Some(Axle::Front)) => Ok((front, rear)),
            (front, Some(rear), Some(Axle::Rear)) => Ok((rear, front)),
            (Some(only), None, None) | (None, Some(only), None) => Ok((only, None)),
            (Some(_), Some(_), None) => Err(self.source.fault(
                "the file has a front and a rear suspension",
                "choose one: --axle front or --axle rear",
            )),
            _ => Err(self.source.fault(
                "the file has no such suspension",
                "look for `FRONT SUSPENSION` and `REAR SUSPENSION` in it",
            )),
        }
    }

    /// The first numbers of a line, counted from 0.
    fn numbers<const N: usize>(&self, index: usize, what: &str) -> Result<[f64; N], ImportError> {
        let line = self.lines.get(index).copied().unwrap_or("");
        let mut words = line.split_whitespace();
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            let parsed = words.next().and_then(|word| word.parse().ok());
            *number = parsed.filter(|number: &f64| number.is_finite()).ok_or_else(|| {
                let place = (index + 1).min(self.lines.len().max(1));
                self.source.mistake(
                    place,
                    format!("here {what} should stand"),
                    "save it anew from Lotus",
                )
            })?;
        }
        Ok(numbers)
    }
}
