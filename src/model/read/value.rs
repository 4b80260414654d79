//! Values of model and architecture files, with what to write instead of wrong ones.

use toml::Spanned;
use toml::de::DeValue;

use crate::model::diagnostics::Report;

/// A value that can be read from TOML.
pub(crate) trait FromToml: Sized {
    /// What is expected, with an example.
    const EXPECTED: &'static str;

    /// The value, or `None` after noting what is wrong with it.
    /// `what` names the value in messages, such as "`radius`".
    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self>;
}

fn wrong_type<T: FromToml>(value: &Spanned<DeValue>, what: &str, report: &mut Report) {
    let found = match value.get_ref() {
        DeValue::String(_) => "a text",
        DeValue::Integer(integer) if integer.radix() != 10 => "a number of another base",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    };
    let message = format!("{what} must be {}, not {found}", T::EXPECTED);
    let help = match value.get_ref() {
        DeValue::String(_) => "numbers and lists stand without quotes".to_owned(),
        DeValue::Integer(integer) if integer.radix() != 10 => "write it in decimals".to_owned(),
        _ => format!("write {}", T::EXPECTED),
    };
    let label = format!("this is {found}");
    report.mistake(&value.span(), message, label).help(help);
}

impl FromToml for String {
    const EXPECTED: &'static str = "a text in double quotes";

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let Some(text) = value.get_ref().as_str() else {
            wrong_type::<Self>(value, what, report);
            return None;
        };
        if text.trim().is_empty() {
            let message = format!("{what} is empty");
            report
                .mistake(&value.span(), message, "empty")
                .help("write something between the quotes");
            return None;
        }
        Some(text.to_owned())
    }
}

impl FromToml for bool {
    const EXPECTED: &'static str = "true or false";

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let flag = value.get_ref().as_bool();
        if flag.is_none() {
            wrong_type::<Self>(value, what, report);
        }
        flag
    }
}

impl FromToml for f64 {
    const EXPECTED: &'static str = "a number such as 12.5";

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let number = match value.get_ref() {
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Float(float) => float.as_str().parse().ok(),
            _ => None,
        };
        let Some(number) = number else {
            wrong_type::<Self>(value, what, report);
            return None;
        };
        if !f64::is_finite(number) {
            report
                .mistake(&value.span(), format!("{what} is not a finite number"), "not finite")
                .help("write the measured value");
            return None;
        }
        Some(number)
    }
}

/// A list of exactly `N` values.
impl<T: FromToml, const N: usize> FromToml for [T; N] {
    const EXPECTED: &'static str = match N {
        2 => "a list of two",
        3 => "three numbers `[x, y, z]`",
        _ => "a list",
    };

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let Some(list) = value.get_ref().as_array() else {
            wrong_type::<Self>(value, what, report);
            return None;
        };
        let entry = entry(what);
        let items: Vec<T> = list.iter().filter_map(|item| T::read(item, &entry, report)).collect();
        if list.len() != N {
            let message = format!("{what} must be {}, not {}", Self::EXPECTED, list.len());
            let label = format!("{} values here", list.len());
            let help = if list.len() == 2 * N {
                "decimals use a point, not a comma: write 420.5, not 420,5".to_owned()
            } else {
                format!("write {}", Self::EXPECTED)
            };
            report.mistake(&value.span(), message, label).help(help);
            return None;
        }
        items.try_into().ok()
    }
}

/// What messages call the values of a list, and those of a row of a table.
fn entry(what: &str) -> String {
    if what.starts_with("an entry of") { what.to_owned() } else { format!("an entry of {what}") }
}

/// A list of any length; `None` where one of its values is wrong.
impl<T: FromToml> FromToml for Vec<T> {
    const EXPECTED: &'static str = "a list";

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let Some(list) = value.get_ref().as_array() else {
            wrong_type::<Self>(value, what, report);
            return None;
        };
        let (entry, before) = (entry(what), report.mistakes.len());
        // All entries are read before one of them can end the list.
        let items: Vec<Option<T>> = list.iter().map(|item| T::read(item, &entry, report)).collect();
        // The same mistake in every row, such as a missing bracket, is one mistake.
        let mut new = report.mistakes.split_off(before);
        new.dedup_by(|next, first| next.message() == first.message());
        report.mistakes.extend(new);
        items.into_iter().collect()
    }
}

/// A value together with its place, for items of lists.
impl<T: FromToml> FromToml for Spanned<T> {
    const EXPECTED: &'static str = T::EXPECTED;

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        Some(Spanned::new(value.span(), T::read(value, what, report)?))
    }
}
