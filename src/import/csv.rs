//! Tables of points as comma-separated values.
//!
//! A row is `name,x,y,z`, or `name_x,value` as in spreadsheets with one coordinate in each row. The
//! columns may
//! be named by a header, and lines such as `# length = mm` say what a table has no column for.

use ::csv::{ReaderBuilder, StringRecord};

use super::options::Options;
use super::points::{Head, Row, suspension};
use super::{ImportError, Imported, Mistakes, Source};
use crate::model::{AngleUnit, Axes, LengthUnit, Side};

/// Whether a text without a telling name may be a table of points.
pub(super) fn is_points(text: &str) -> bool {
    let lines = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    let mut lines = lines.take(20).peekable();
    lines.peek().is_some() && lines.all(|line| line.contains([',', ';', '\t']))
}

pub(super) fn import(source: Source, options: &Options) -> Result<Imported, ImportError> {
    let mut mistakes = Mistakes::new(source.name, source.text);
    let head = head(source.text, &mut mistakes);
    let table = Table::read(source, &mut mistakes);
    let rows = table.points(&mut mistakes);
    mistakes.finish()?;
    if rows.is_empty() {
        return Err(source
            .fault("the file has no points", "write rows such as `lca_front,200.0,420.0,-270.0`"));
    }
    let head = Head { length: head.length.or(table.unit), ..head };
    suspension(source, &head, rows, options)
}

/// What lines such as `# axes = iso8855` say.
fn head(text: &str, mistakes: &mut Mistakes) -> Head {
    let mut head = Head { format: "a table of points", ..Head::default() };
    for (index, line) in text.lines().enumerate() {
        let Some((key, value)) =
            line.trim().strip_prefix('#').and_then(|line| line.split_once('='))
        else {
            continue;
        };
        let (line, value) = (index + 1, value.trim().trim_matches([',', ';', '"']).trim());
        let mut wrong = |what: &str| {
            mistakes.note(line, format!("`{value}` is no {what}"), "see docs/import.md");
        };
        let mut number = || {
            let number = value.parse().ok().filter(|number: &f64| number.is_finite());
            if number.is_none() {
                wrong("number");
            }
            number
        };
        match key.trim() {
            "name" => head.name = Some(value.to_owned()),
            "architecture" => head.architecture = Some(value.to_owned()),
            "spin_axis_point" => head.spin_axis_point = Some(value.to_owned()),
            "wheel_radius" => head.radius = number(),
            "toe" => head.toe = number(),
            "camber" => head.camber = number(),
            "length" => match choice(LengthUnit::CHOICES, value) {
                None => wrong("unit of length"),
                length => head.length = length,
            },
            "angle" => match choice(AngleUnit::CHOICES, value) {
                None => wrong("unit of angle"),
                angle => head.angle = angle,
            },
            "axes" => match choice(Axes::CHOICES, value) {
                None => wrong("axis system"),
                axes => head.axes = axes,
            },
            "side" => match choice(Side::CHOICES, value) {
                None => wrong("side"),
                side => head.side = side,
            },
            // Any other comment.
            _ => {}
        }
    }
    head
}

fn choice<T: Copy>(choices: &[(&str, T)], word: &str) -> Option<T> {
    let word = word.to_ascii_lowercase();
    choices.iter().find(|(name, _)| *name == word).map(|(_, value)| *value)
}

/// The rows of a file, and which columns they have.
struct Table {
    rows: Vec<(usize, StringRecord)>,
    columns: Columns,
    /// The unit that the header names.
    unit: Option<LengthUnit>,
    /// Numbers are written with a decimal comma.
    comma: bool,
}

/// Where name and numbers stand.
#[derive(Clone, Copy)]
enum Columns {
    /// One point in each row.
    Points { name: usize, xyz: [usize; 3] },
    /// One coordinate in each row, with its axis at the end of the name.
    Values { name: usize, value: usize },
}

impl Table {
    fn read(source: Source, mistakes: &mut Mistakes) -> Self {
        let delimiter = delimiter(source.text);
        let mut reader = ReaderBuilder::new()
            .delimiter(delimiter)
            .comment(Some(b'#'))
            .has_headers(false)
            .flexible(true)
            .trim(::csv::Trim::All)
            .from_reader(source.text.as_bytes());
        let mut rows = vec![];
        for record in reader.records() {
            match record {
                Ok(record) => {
                    let line = record.position().map_or(1, ::csv::Position::line);
                    let line = usize::try_from(line).unwrap_or(usize::MAX);
                    if record.iter().any(|cell| !cell.is_empty()) {
                        rows.push((line, record));
                    }
                }
                Err(error) => mistakes.note(
                    1,
                    format!("a row cannot be read: {error}"),
                    "save the table anew",
                ),
            }
        }
        let mut table = Self {
            columns: Columns::Points { name: 0, xyz: [1, 2, 3] },
            unit: None,
            comma: delimiter != b',' && source.text.contains(','),
            rows,
        };
        table.header();
        table
    }

    /// Takes a header off, where there is one, and learns from it.
    fn header(&mut self) {
        let Some((_, first)) = self.rows.first() else { return };
        let names: Vec<String> = first.iter().map(heading).collect();
        let find =
            |choices: &[&str]| names.iter().position(|name| choices.contains(&name.as_str()));
        let name =
            find(&["name", "point", "pointname", "hardpoint", "hardpointname", "parameter", ""]);
        let xyz = [find(&["x", "xvalue"]), find(&["y", "yvalue"]), find(&["z", "zvalue"])];
        let value = find(&["value", "wert"]);
        if let [Some(x), Some(y), Some(z)] = xyz {
            self.columns = Columns::Points { name: name.unwrap_or(0), xyz: [x, y, z] };
            self.unit = first.iter().find_map(unit_of_heading);
            self.rows.remove(0);
        } else if let (Some(name), Some(value)) = (name, value) {
            self.columns = Columns::Values { name, value };
            self.unit = first.iter().find_map(unit_of_heading);
            self.rows.remove(0);
        } else if self
            .rows
            .iter()
            .all(|(_, row)| row.iter().filter(|cell| !cell.is_empty()).count() == 2)
        {
            self.columns = Columns::Values { name: 0, value: 1 };
        }
    }

    fn points(&self, mistakes: &mut Mistakes) -> Vec<Row> {
        match self.columns {
            Columns::Points { name, xyz } => {
                let rows = self.rows.iter().map(|(line, record)| {
                    let called = self.name(*line, record, name, mistakes)?;
                    let [x, y, z] =
                        xyz.map(|column| self.number(*line, record, column, &called, mistakes));
                    Some(Row { line: *line, called, position: [x?, y?, z?] })
                });
                rows.flatten().collect()
            }
            Columns::Values { name, value } => self.triples(name, value, mistakes),
        }
    }

    /// Points whose coordinates stand in three rows: `F_LCA_O_x`, `F_LCA_O_y`, `F_LCA_O_z`.
    fn triples(&self, name: usize, value: usize, mistakes: &mut Mistakes) -> Vec<Row> {
        let mut found: Vec<(usize, String, [Option<f64>; 3])> = vec![];
        let mut places = std::collections::HashMap::new();
        for (line, record) in &self.rows {
            let Some(called) = self.name(*line, record, name, mistakes) else { continue };
            let Some((base, axis)) = axis_of(&called) else {
                let help = "a name ends in _x, _y or _z: `F_LCA_O_x`; delete rows that are no coordinates, or put # before them";
                mistakes.note(*line, format!("`{called}` is no coordinate of a point"), help);
                continue;
            };
            let Some(number) = self.number(*line, record, value, &called, mistakes) else {
                continue;
            };
            let place = *places.entry(base.to_owned()).or_insert_with(|| {
                found.push((*line, base.to_owned(), [None; 3]));
                found.len() - 1
            });
            if found[place].2[axis].replace(number).is_some() {
                mistakes.note(
                    *line,
                    format!("`{called}` stands there twice"),
                    "keep one of the rows",
                );
            }
        }
        let mut rows = vec![];
        for (line, called, position) in found {
            match position {
                [Some(x), Some(y), Some(z)] => rows.push(Row { line, called, position: [x, y, z] }),
                _ => {
                    let what = format!("the point `{called}` has not all of x, y and z");
                    mistakes.note(line, what, "add the rows that are missing");
                }
            }
        }
        rows
    }

    fn name(
        &self,
        line: usize,
        record: &StringRecord,
        column: usize,
        mistakes: &mut Mistakes,
    ) -> Option<String> {
        let name = record.get(column).filter(|name| !name.is_empty());
        if name.is_none() {
            mistakes.note(line, "this row has no name of a point", "write `name,x,y,z`");
        }
        name.map(str::to_owned)
    }

    fn number(
        &self,
        line: usize,
        record: &StringRecord,
        column: usize,
        called: &str,
        mistakes: &mut Mistakes,
    ) -> Option<f64> {
        let cell = record.get(column).unwrap_or("");
        let text = if self.comma { cell.replace(',', ".") } else { cell.to_owned() };
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        if number.is_none() {
            let what = match cell {
                "" => format!("`{called}` lacks a number in column {}", column + 1),
                _ => format!("`{cell}` in the row of `{called}` is no number"),
            };
            mistakes.note(line, what, "write `name,x,y,z` with a point as the decimal sign");
        }
        number
    }
}

/// What stands between cells: the one of these that the most rows have.
fn delimiter(text: &str) -> u8 {
    let lines = || text.lines().filter(|line| !line.starts_with('#')).take(100);
    let count = |sign: u8| lines().filter(|line| line.as_bytes().contains(&sign)).count();
    // A semicolon or a tab is never part of a number, while a comma may be a decimal sign.
    let [tabs, semicolons, commas] = [b'\t', b';', b','].map(count);
    match () {
        () if semicolons > 0 && semicolons >= tabs => b';',
        () if tabs > 0 && 2 * tabs >= commas => b'\t',
        () => b',',
    }
}

/// The name of a column without its unit.
fn heading(cell: &str) -> String {
    let name = cell.split(['[', '(', '<']).next().unwrap_or(cell);
    crate::model::suggest::plain(name)
}

fn unit_of_heading(cell: &str) -> Option<LengthUnit> {
    let (_, unit) = cell.split_once(['[', '(', '<'])?;
    choice(LengthUnit::CHOICES, unit.trim_end_matches([']', ')', '>']).trim())
}

/// `F_LCA_O_x` is x of `F_LCA_O`.
fn axis_of(name: &str) -> Option<(&str, usize)> {
    let (base, axis) = name.rsplit_once(['_', '.', '-', ' '])?;
    let axis = match axis {
        "x" | "X" => 0,
        "y" | "Y" => 1,
        "z" | "Z" => 2,
        _ => return None,
    };
    Some((base, axis)).filter(|(base, _)| !base.is_empty())
}
