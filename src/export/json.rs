//! The whole file as JSON: the same keys, in the same order, with the same numbers.

use serde_json::{Map, Value as Json};
use toml::{Table, Value};

pub(super) fn write(table: Table) -> String {
    let json = json_of(Value::Table(table));
    let mut text = serde_json::to_string_pretty(&json).unwrap_or_default();
    text.push('\n');
    text
}

fn json_of(value: Value) -> Json {
    match value {
        Value::String(text) => Json::String(text),
        Value::Integer(number) => Json::from(number),
        Value::Float(number) => Json::from(number),
        Value::Boolean(value) => Json::Bool(value),
        Value::Datetime(date) => Json::String(date.to_string()),
        Value::Array(items) => items.into_iter().map(json_of).collect(),
        Value::Table(table) => {
            let members = table.into_iter().map(|(key, value)| (key, json_of(value)));
            Json::Object(members.collect::<Map<_, _>>())
        }
    }
}
