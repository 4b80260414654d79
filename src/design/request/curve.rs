//! Curves: rows of the value of an event and the value of a factor.

use std::ops::Range;
use std::path::Path;

use toml::Spanned;

use super::read::Context;
use crate::model::read::{FromToml, Section};
use crate::model::{
    AngleUnit, ForceUnit, LengthUnit, Quantity, Report, SourceFile, Units, read_text, suggest,
};

/// A column: its usual names and what its values are.
pub(super) struct Column<'a> {
    pub(super) names: &'a [&'a str],
    pub(super) quantity: Quantity,
}

/// The rows (SI) of `curve`, with increasing first values.
pub(super) fn read(
    section: &mut Section,
    columns: &[Column; 2],
    context: &Context,
    report: &mut Report,
) -> Option<Vec<[f64; 2]>> {
    let value = section.value("curve")?;
    let named = ["x", "y"].map(|key| section.optional::<String>(key, report));
    let mut rows = if value.get_ref().is_str() {
        let path = String::read(value, "`curve`", report)?;
        file(&Spanned::new(value.span(), path), &named, columns, context, report)?
    } else {
        if let Some(named) = named.iter().flatten().next() {
            report
                .mistake(&named.span(), "`x` and `y` name columns of a file", "no file")
                .help("leave them out, or name a file: `curve = \"measured.csv\"`");
        }
        let rows = Vec::<[f64; 2]>::read(value, "`curve`", report)?;
        let si = |row: [f64; 2]| [0, 1].map(|k| context.si(columns[k].quantity, row[k]));
        rows.into_iter().map(si).collect::<Vec<_>>()
    };
    if rows.is_empty() {
        report
            .mistake(&value.span(), "the curve has no rows", "empty")
            .help("write rows such as `[[-50.0, 1.2], [0.0, 0.0]]`");
        return None;
    }
    rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
    Some(rows)
}

/// The two columns of a file of comma-separated values.
fn file(
    named: &Spanned<String>,
    wanted: &[Option<Spanned<String>>; 2],
    columns: &[Column; 2],
    context: &Context,
    report: &mut Report,
) -> Option<Vec<[f64; 2]>> {
    let request = Path::new(&report.file().name);
    let path = request.parent().unwrap_or(Path::new("")).join(named.get_ref());
    let text = match read_text(&path) {
        Ok(text) => text,
        Err((message, help)) => {
            let help = format!("{help}; the path is relative to this file");
            report.mistake(&named.span(), message, "the curve").help(help);
            return None;
        }
    };
    let mut own = Report::new(SourceFile::new(&path.display().to_string(), &text));
    let mut lines = lines(&text);
    let header = lines.next().unwrap_or_default();
    let mut found = vec![];
    for (column, wanted) in columns.iter().zip(wanted) {
        found.push(find(column, wanted.as_ref(), &header, named, context, report));
    }
    let (x, y) = (found.remove(0)?, found.remove(0)?);
    let mut rows = vec![];
    for fields in lines {
        if own.mistakes.len() > 5 {
            break; // They are all of one kind.
        }
        if fields.len() != header.len() {
            let place = fields[0].1.start..fields[fields.len() - 1].1.end;
            let message =
                format!("this line has {} values for {} columns", fields.len(), header.len());
            own.mistake(&place, message, "this line")
                .help("write as many values as the first line has names; decimals have a point");
            continue;
        }
        let read = |(place, units, quantity): &(usize, Units, Quantity), own: &mut Report| {
            let (text, span) = &fields[*place];
            let value = text.parse().ok().filter(|value: &f64| value.is_finite());
            if value.is_none() {
                own.mistake(span, format!("`{text}` is not a number"), "not a number")
                    .help("write a number such as -0.25, with a decimal point");
            }
            Some(quantity.to_si(*units, value?))
        };
        rows.push((read(&x, &mut own), read(&y, &mut own)));
    }
    let whole = own.mistakes.is_empty();
    report.mistakes.append(&mut own.mistakes);
    let rows: Vec<[f64; 2]> = rows.into_iter().filter_map(|(x, y)| Some([x?, y?])).collect();
    whole.then_some(rows)
}

/// The place of a column with the units that its name has behind it.
fn find(
    column: &Column,
    wanted: Option<&Spanned<String>>,
    header: &[Field],
    file: &Spanned<String>,
    context: &Context,
    report: &mut Report,
) -> Option<(usize, Units, Quantity)> {
    let own = context.model.units;
    let is_usual = |name: &str| {
        column.names.iter().any(|usual| {
            name == *usual
                || name
                    .strip_prefix(usual)
                    .and_then(|rest| rest.strip_prefix('_'))
                    .is_some_and(|unit| units_of(unit, column, own).is_some())
        })
    };
    let place = match wanted {
        Some(wanted) => header.iter().position(|(name, _)| name == wanted.get_ref()),
        None => header.iter().position(|(name, _)| is_usual(name)),
    };
    let Some(place) = place else {
        let names: Vec<&str> = header.iter().map(|(name, _)| *name).collect();
        let word = wanted.map_or(column.names[0], |wanted| wanted.get_ref());
        let message = format!("`{}` has no column `{word}`", file.get_ref());
        let span = wanted.map_or(file.span(), Spanned::span);
        let help = match wanted {
            Some(_) => suggest::choices(word, &names),
            None => format!("name it with `x` or `y`; the columns are {}", suggest::listed(&names)),
        };
        report.mistake(&span, message, "no such column").help(help);
        return None;
    };
    let name = header[place].0;
    let behind = name.rsplit_once('_').map(|(_, unit)| unit);
    let units = behind.and_then(|unit| units_of(unit, column, own));
    if let (None, Some(unit)) = (units, behind)
        && is_unit(unit)
    {
        let symbol = column.quantity.symbol(own);
        let message = format!("the column `{name}` is not in {symbol} or the like");
        let span = wanted.map_or(file.span(), Spanned::span);
        report
            .mistake(&span, message, format!("in `{unit}`"))
            .help(format!("name a column in {symbol}, or one whose name ends in no unit"));
        return None;
    }
    Some((place, units.unwrap_or(own), column.quantity))
}

/// The units with which a quantity has this symbol; those of the model come first.
fn units_of(symbol: &str, column: &Column, own: Units) -> Option<Units> {
    let all = LengthUnit::CHOICES.iter().flat_map(|(_, length)| {
        AngleUnit::CHOICES.iter().flat_map(move |(_, angle)| {
            let units = Units { length: *length, angle: *angle, ..own };
            ForceUnit::CHOICES.iter().map(move |(_, force)| Units { force: *force, ..units })
        })
    });
    let plain = |text: String| text.replace('·', "").to_lowercase();
    let symbol = plain(symbol.to_owned());
    let is_meant = |units: &Units| {
        let percent = column.quantity == Quantity::Percent && symbol == "pct";
        percent || plain(column.quantity.symbol(*units)) == symbol
    };
    std::iter::once(own).chain(all).find(is_meant)
}

/// Whether a word is the symbol of a unit of length, angle or force.
fn is_unit(word: &str) -> bool {
    let lengths = LengthUnit::CHOICES.iter().map(|(symbol, _)| *symbol);
    let angles = AngleUnit::CHOICES.iter().map(|(symbol, _)| *symbol);
    let forces = ForceUnit::CHOICES.iter().map(|(symbol, _)| *symbol);
    lengths.chain(angles).chain(forces).any(|symbol| symbol == word)
}

/// A field and its place in the text.
type Field<'t> = (&'t str, Range<usize>);

/// The lines that say something, split where the first of them is: at semicolons, tabs or commas.
fn lines(text: &str) -> impl Iterator<Item = Vec<Field<'_>>> {
    let says_something = |line: &&str| {
        let line = line.trim_start_matches('\u{feff}').trim();
        !line.is_empty() && !line.starts_with('#')
    };
    let place = move |line: &str| line.as_ptr() as usize - text.as_ptr() as usize;
    let first = text.lines().find(says_something).unwrap_or_default();
    let mark = [';', '\t'].into_iter().find(|mark| first.contains(*mark)).unwrap_or(',');
    text.lines().filter(says_something).map(move |line| {
        let mut quoted = false;
        let ends = |letter: char| {
            quoted ^= letter == '"';
            letter == mark && !quoted
        };
        let fields = line.split(ends).map(|field| {
            let blank = |letter: char| letter.is_whitespace() || "\u{feff}\"".contains(letter);
            let field = field.trim_matches(blank);
            let start = place(field);
            (field, start..start + field.len())
        });
        fields.collect()
    })
}
