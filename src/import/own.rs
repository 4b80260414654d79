//! Models and mechanisms of hardpoint that were written as JSON.

use super::json::{Json, Kind};
use super::{ImportError, Imported, Source};
use crate::model::Document;

/// The same file as TOML: every key and every number is that of the JSON.
pub(super) fn import(source: Source, root: &Json) -> Result<Imported, ImportError> {
    let mut table = match toml_of(root) {
        Some(toml::Value::Table(table)) => table,
        _ => {
            let what = "the file has an empty value (null)";
            return Err(source.fault(what, "give it a value or delete it"));
        }
    };
    // The version is a whole number; all others may be written as such or not.
    if table.get("format").and_then(toml::Value::as_float) == Some(1.0) {
        table.insert("format".to_owned(), toml::Value::Integer(1));
    }
    let text = toml::to_string(&table).map_err(|error| {
        source.fault(format!("it cannot be written as TOML: {error}"), "correct the file")
    })?;
    Document::parse(&format!("{} (as TOML)", source.name), &text)?;
    Ok(Imported { text, ..Imported::default() })
}

/// The value as TOML, which has no `null`.
fn toml_of(json: &Json) -> Option<toml::Value> {
    Some(match &json.kind {
        Kind::Null => return None,
        Kind::Bool(value) => toml::Value::Boolean(*value),
        Kind::Text(text) => toml::Value::String(text.clone()),
        Kind::Number(number) => toml::Value::Float(*number),
        Kind::List(items) => toml::Value::Array(items.iter().map(toml_of).collect::<Option<_>>()?),
        Kind::Object(members) => {
            let members = members.iter().map(|(key, value)| Some((key.clone(), toml_of(value)?)));
            toml::Value::Table(members.collect::<Option<_>>()?)
        }
    })
}
