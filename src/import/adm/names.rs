//! Names of parts, markers and elements.

use std::collections::HashMap;

use super::statement::Statement;

/// Names for what has numbers in the dataset, with the last number that each name has got.
#[derive(Default)]
pub(super) struct Names(HashMap<String, usize>);

impl Names {
    /// The name that Adams/View gave, or the kind with the number.
    pub(super) fn take(&mut self, statement: &Statement, kind: &str) -> String {
        let numbered = match statement.id {
            Some(id) if kind != "ground" => format!("{kind}_{id}"),
            _ => kind.to_owned(),
        };
        let one_word = |name: &&String| {
            !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || "_-".contains(c))
        };
        let given = statement.name.as_ref().filter(one_word).cloned();
        self.own(given.unwrap_or(numbered))
    }

    /// The name, with a number where it is taken.
    pub(super) fn own(&mut self, name: String) -> String {
        let mut number = self.0.get(&name).copied().unwrap_or(0);
        let mut own = name.clone();
        while number > 0 && self.0.contains_key(&own) {
            number += 1;
            own = format!("{name}_{number}");
        }
        self.0.insert(name, number.max(1));
        self.0.entry(own.clone()).or_insert(1);
        own
    }
}
