//! Files of load cases: a table of what the rig does, one state a line.

use std::ops::Range;
use std::path::Path;

use super::case_input::CaseInput;
use super::diagnostics::{Mistake, ModelDiagnostics, Report, SourceFile};
use super::load::read_file;
use super::{Model, Quantity, suggest};

/// No rig moves a wheel or a rack farther (m).
const FARTHEST: f64 = 1e3;

/// A column of cases.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseColumn {
    /// The name in the file, without the unit.
    pub name: String,
    /// What it says.
    pub input: CaseInput,
}

/// One state that the rig is to reach.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadCase {
    /// The name of the file, or `line 7`.
    pub name: String,
    /// The values (SI) of all columns; `None` where the file has none.
    pub values: Vec<Option<f64>>,
}

/// A file of load cases.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadCases {
    /// The columns but that of names.
    pub columns: Vec<CaseColumn>,
    /// The cases in the order of the file.
    pub cases: Vec<LoadCase>,
}

impl LoadCases {
    /// Reads a file of cases for a corner, or for both sides as an axle, in the units of the model.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the file.
    pub fn load(
        path: impl AsRef<Path>,
        model: &Model,
        axle: bool,
    ) -> Result<Self, ModelDiagnostics> {
        let (name, text) = read_file(path.as_ref())?;
        Self::parse(&name, &text, model, axle)
    }

    /// Reads cases from the text of a file, whose name messages show. The first line names the columns, with
    /// or without their units; a line that begins with # is a comment.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the text.
    pub fn parse(
        name: &str,
        text: &str,
        model: &Model,
        axle: bool,
    ) -> Result<Self, ModelDiagnostics> {
        let mut report = Report::new(SourceFile::new(name, text));
        let mut lines = lines(text);
        let Some((_, header)) = lines.next() else {
            let help = "write the names of columns in the first line, such as name,fx,rack";
            let mistake = Mistake::without_place(format!("{name} has no cases"), help);
            return Err(ModelDiagnostics::new(name, vec![mistake]));
        };
        let columns = Columns::read(&header, model, axle, &mut report);
        let cases: Vec<LoadCase> = lines
            .map(|(number, fields)| columns.case(number, &fields, model, &mut report))
            .collect();
        if cases.is_empty() {
            let end = header.last().map_or(0, |field| field.1.end);
            report
                .mistake(&(end..end), "there are no cases", "nothing follows")
                .help("write one state in each line below the names");
        }
        report.finish()?;
        let columns = columns.0.into_iter().flatten().filter_map(Column::input).collect();
        Ok(Self { columns, cases })
    }

    /// Whether a column holds wheels vertically; otherwise they are free, on their tyres.
    pub fn holds_wheels(&self) -> bool {
        self.columns.iter().any(|column| column.input.holds())
    }
}

/// What a column of the file says; the unknown ones are `None`.
struct Columns(Vec<Option<Column>>);

#[derive(Clone)]
enum Column {
    Name,
    Input(CaseColumn),
}

impl Column {
    fn input(self) -> Option<CaseColumn> {
        match self {
            Self::Name => None,
            Self::Input(column) => Some(column),
        }
    }
}

/// A field and its place in the text.
type Field<'a> = (&'a str, Range<usize>);

impl Columns {
    fn read(header: &[Field], model: &Model, axle: bool, report: &mut Report) -> Self {
        let mut columns: Vec<Option<Column>> = vec![];
        for (name, span) in header {
            let column = column(name, span, model, axle, report);
            if let Some(Column::Input(CaseColumn { input, .. })) = &column {
                let same = |other: &&Option<Column>| matches!(other, Some(Column::Input(other)) if other.input.collides(*input));
                if let Some(Some(Column::Input(other))) = columns.iter().find(same) {
                    let message = format!("`{name}` and `{}` say the same", other.name);
                    report.mistake(span, message, "once more").help("leave out one of them");
                }
            }
            columns.push(column);
        }
        Self(columns)
    }

    fn case(&self, line: usize, fields: &[Field], model: &Model, report: &mut Report) -> LoadCase {
        let (first, last) = (&fields[0].1, &fields[fields.len() - 1].1);
        let whole = first.start..last.end;
        if fields.len() != self.0.len() {
            let message =
                format!("this line has {} values for {} columns", fields.len(), self.0.len());
            report
                .mistake(&whole, message, "this line")
                .help("leave a value empty, but keep its comma");
        }
        let mut case = LoadCase { name: format!("line {line}"), values: vec![] };
        let mut held: Vec<CaseInput> = vec![];
        for (column, (text, span)) in self.0.iter().zip(fields) {
            match column {
                Some(Column::Name) if !text.is_empty() => case.name = (*text).to_owned(),
                Some(Column::Input(CaseColumn { name, input })) => {
                    let value = number(text, span, name, *input, model, report);
                    if value.is_some() && input.holds() {
                        held.push(*input);
                    }
                    case.values.push(value);
                }
                _ => {}
            }
        }
        let both = |input: &CaseInput| {
            matches!(input, CaseInput::Travel(side) if held.iter().any(
                |other| matches!(other, CaseInput::WheelForce(_))
                    && CaseInput::Travel(other.side()).collides(CaseInput::Travel(*side))
            ))
        };
        if held.iter().any(both) {
            report
                .mistake(&whole, "a wheel is held both by its travel and by its force", "this case")
                .help("leave one of the two empty");
        }
        case
    }
}

/// What the name of a column says.
fn column(
    name: &str,
    span: &Range<usize>,
    model: &Model,
    axle: bool,
    report: &mut Report,
) -> Option<Column> {
    if name == "name" || name == "case" {
        return Some(Column::Name);
    }
    let is_named = |(known, input): &(String, CaseInput)| {
        name == known || name == input.quantity().column(known, model.units)
    };
    let Some((known, input)) = CaseInput::all().find(is_named) else {
        let names: Vec<String> = CaseInput::all().map(|(name, _)| name).collect();
        let mut known = vec!["name"];
        known.extend(names.iter().map(String::as_str));
        report
            .mistake(span, format!("there is no column `{name}`"), "unknown column")
            .help(suggest::choices(name, &known));
        return None;
    };
    let has_forces = if axle { model.axle_has_forces() } else { model.has_forces() };
    let wrong = match input {
        _ if input.side().is_some() && !axle => {
            Some(("this is the wheel of an axle", "add --axle, or leave out the side"))
        }
        CaseInput::Rack if !model.steers() => {
            Some(("the model has no rack", "leave out this column"))
        }
        CaseInput::Load(..) | CaseInput::WheelForce(_) if !has_forces => Some((
            "the model has no forces, so a load moves nothing",
            "add springs to the model, or leave out this column",
        )),
        _ => None,
    };
    if let Some((message, help)) = wrong {
        report.mistake(span, message, format!("`{name}`")).help(help);
        return None;
    }
    Some(Column::Input(CaseColumn { name: known, input }))
}

/// The value (SI) of a field; `None` where it is empty or wrong.
fn number(
    text: &str,
    span: &Range<usize>,
    name: &str,
    input: CaseInput,
    model: &Model,
    report: &mut Report,
) -> Option<f64> {
    if text.is_empty() {
        return None;
    }
    let Some(value) = text.parse().ok().filter(|value: &f64| value.is_finite()) else {
        report
            .mistake(span, format!("`{name}` must be a number, not `{text}`"), "not a number")
            .help("write a number such as -250.5, with a decimal point");
        return None;
    };
    let value = input.quantity().to_si(model.units, value);
    if input.quantity() == Quantity::Length && value.abs() > FARTHEST {
        report
            .mistake(span, format!("`{name}` is more than a kilometre"), "too far")
            .help("lengths are in the unit of the model");
        return None;
    }
    Some(value)
}

/// The lines that say something, with their numbers from 1 and their fields with quotes and blanks taken
/// away.
fn lines(text: &str) -> impl Iterator<Item = (usize, Vec<Field<'_>>)> {
    let says_something = |(_, line): &(usize, &str)| {
        let line = line.trim_start_matches('\u{feff}').trim();
        !line.is_empty() && !line.starts_with('#')
    };
    let place = move |line: &str| line.as_ptr() as usize - text.as_ptr() as usize;
    text.lines().enumerate().filter(says_something).map(move |(index, line)| {
        let mut quoted = false;
        let is_comma = |letter: char| {
            quoted ^= letter == '"';
            letter == ',' && !quoted
        };
        let fields = line.split(is_comma).map(|field| {
            let blank = |letter: char| letter.is_whitespace() || "\u{feff}\"".contains(letter);
            let field = field.trim_matches(blank);
            let start = place(field);
            (field, start..start + field.len())
        });
        (index + 1, fields.collect())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Side;

    fn model() -> Model {
        Model::load("models/sedan-axle.toml").unwrap_or_else(|error| panic!("{}", error.render()))
    }

    fn mistakes(text: &str, axle: bool) -> Vec<(String, Option<(usize, usize)>)> {
        let error = LoadCases::parse("cases.csv", text, &model(), axle).unwrap_err();
        let mistakes = error.mistakes().iter();
        mistakes.map(|m| (m.message().to_owned(), m.line_and_column())).collect()
    }

    #[test]
    fn cases_are_read_in_the_units_of_the_model() {
        let text = "\u{feff}# three cases\nname, rack_mm, left_fx ,right_mz, travel\n\
                    \"braking, hard\",1.5,-2000,,\n\n,,,30,-20\nlast,0,0,0,\r\n";
        let found = LoadCases::parse("cases.csv", text, &model(), true).unwrap();
        let names: Vec<&str> = found.columns.iter().map(|column| &*column.name).collect();
        assert_eq!(names, ["rack", "left_fx", "right_mz", "travel"]);
        assert_eq!(found.columns[2].input, CaseInput::Load(5, Some(Side::Right)));
        let cases: Vec<_> =
            found.cases.iter().map(|case| (&*case.name, &case.values[..])).collect();
        assert_eq!(cases[0], ("braking, hard", &[Some(0.0015), Some(-2000.0), None, None][..]));
        assert_eq!(cases[1], ("line 5", &[None, None, Some(0.03), Some(-0.02)][..]));
        assert_eq!(cases[2], ("last", &[Some(0.0), Some(0.0), Some(0.0), None][..]));
        assert!(found.holds_wheels());
    }

    #[test]
    fn mistakes_have_their_places() {
        let found = mistakes("name,left_fxx,fy,left_fy\na,1,2\nb,1,two,inf\n", true);
        let expected = [
            ("there is no column `left_fxx`", (1, 6)),
            ("`left_fy` and `fy` say the same", (1, 18)),
            ("this line has 3 values for 4 columns", (2, 1)),
            ("`fy` must be a number, not `two`", (3, 5)),
            ("`left_fy` must be a number, not `inf`", (3, 9)),
        ];
        let expected = expected.map(|(message, place)| (message.to_owned(), Some(place)));
        assert_eq!(found, expected);
    }

    #[test]
    fn sides_need_an_axle_and_wheels_one_hold() {
        assert_eq!(mistakes("left_fx\n1\n", false)[0].0, "this is the wheel of an axle");
        assert_eq!(mistakes("fx\n", true)[0].0, "there are no cases");
        assert_eq!(mistakes("# fx\n", true)[0].0, "cases.csv has no cases");
        assert_eq!(mistakes("travel\n2e6\n", true)[0].0, "`travel` is more than a kilometre");
        let both = mistakes("left_travel,wheel_force\n1,\n,3000\n1,3000\n", true);
        let message = "a wheel is held both by its travel and by its force".to_owned();
        assert_eq!(both, [(message, Some((4, 1)))]);
    }
}
