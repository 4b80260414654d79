//! Statements: their keys, words and numbers.

use std::cell::Cell;

use super::notes::Notes;

/// Stands for the end of a line inside a statement that goes on.
pub(super) const NEW_LINE: char = '\u{1}';

/// One statement, such as `JOINT/3, REVOLUTE, I = 12, J = 22`.
#[derive(Debug)]
pub(super) struct Statement {
    /// The line that it begins in, counted from 1.
    pub(super) line: usize,
    /// Its keyword in full, or as written where it is not known.
    pub(super) keyword: String,
    /// The number behind the slash.
    pub(super) id: Option<u32>,
    /// The name that Adams/View has written in the comment before it.
    pub(super) name: Option<String>,
    pub(super) arguments: Vec<Argument>,
}

/// A word, or a key with its value.
#[derive(Debug)]
pub(super) struct Argument {
    pub(super) line: usize,
    /// In capitals, in full where it is known.
    pub(super) key: String,
    pub(super) value: Option<String>,
    pub(super) used: Cell<bool>,
}

/// All statements of Adams/Solver; those behind the others have an effect that is none of a mechanism's.
pub(super) const KEYWORDS: &[&str] = &[
    "ACCGRAV",
    "ARRAY",
    "BEAM",
    "BUSHING",
    "CONTACT",
    "COUPLER",
    "CURVE",
    "CVCV",
    "DEBUG",
    "DIFF",
    "END",
    "EQUILIBRIUM",
    "FEMDATA",
    "FIELD",
    "FLEX_BODY",
    "FRICTION",
    "GCON",
    "GEAR",
    "GFORCE",
    "GRAPHICS",
    "GSE",
    "IC",
    "INTEGRATOR",
    "JOINT",
    "JPRIM",
    "KINEMATICS",
    "LIST",
    "LSE",
    "MARKER",
    "MATRIX",
    "MFORCE",
    "MOTION",
    "MREQUEST",
    "NFORCE",
    "OUTPUT",
    "PART",
    "PINPUT",
    "POINT_MASS",
    "POUTPUT",
    "PREFERENCES",
    "PTCV",
    "REQUEST",
    "RESULTS",
    "SENSOR",
    "SFORCE",
    "SPLINE",
    "SPRINGDAMPER",
    "STRING",
    "SURFACE",
    "TFSISO",
    "TIRE",
    "UCON",
    "UNITS",
    "VARIABLE",
    "VFORCE",
    "VTORQUE",
];

/// The word in full: itself, or the only one that begins so.
pub(super) fn in_full(word: &str, words: &[&'static str]) -> Option<&'static str> {
    if let Some(same) = words.iter().find(|full| **full == word) {
        return Some(same);
    }
    let mut longer = words.iter().filter(|full| !word.is_empty() && full.starts_with(word));
    longer.next().filter(|_| longer.next().is_none()).copied()
}

/// A number; one that ends in D is an angle in degrees and becomes radians.
pub(super) fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let (digits, degrees) = match text.strip_suffix(['D', 'd']) {
        Some(digits) => (digits.trim_end(), true),
        None => (text, false),
    };
    // Otherwise `inf` and `nan` would be numbers.
    let plain = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    let number: f64 = digits.chars().all(plain).then(|| digits.parse().ok()).flatten()?;
    let number = if degrees { number.to_radians() } else { number };
    number.is_finite().then_some(number)
}

/// The beginning of a text, for messages.
pub(super) fn shortened(text: &str) -> String {
    let text: String = text.chars().map(|c| if c == NEW_LINE { ' ' } else { c }).collect();
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

impl Statement {
    /// The keyword with the number, as in the dataset.
    pub(super) fn title(&self) -> String {
        match self.id {
            Some(id) => format!("{}/{id}", self.keyword),
            None => self.keyword.clone(),
        }
    }

    /// Writes keys in full; `known` are those of this kind of statement.
    pub(super) fn know(&mut self, known: &[&'static str]) {
        for argument in &mut self.arguments {
            if let Some(full) = in_full(&argument.key, known) {
                argument.key = full.to_owned();
            }
        }
    }

    fn find(&self, key: &str) -> Option<&Argument> {
        let found = self.arguments.iter().find(|argument| argument.key == key)?;
        found.used.set(true);
        Some(found)
    }

    /// Whether a key or a word is there.
    pub(super) fn has(&self, key: &str) -> bool {
        self.find(key).is_some()
    }

    /// The first of some words that is there.
    pub(super) fn word(&self, words: &[&'static str]) -> Option<&'static str> {
        words.iter().copied().find(|word| self.has(word))
    }

    /// The value of a key as it is written, with its line.
    pub(super) fn text(&self, key: &str) -> Option<(usize, &str)> {
        let found = self.find(key)?;
        found.value.as_deref().map(|value| (found.line, value))
    }

    /// Numbers, angles in radians; `None` where they are absent or, which is noted, wrong.
    pub(super) fn list(&self, key: &str, notes: &mut Notes) -> Option<Vec<f64>> {
        let (line, text) = self.text(key)?;
        let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
        if numbers.is_none() {
            let what =
                format!("{} of {} is no list of numbers: {}", key, self.title(), shortened(text));
            notes.mistake(line, what, "write numbers with commas between them");
        }
        numbers
    }

    /// A given count of numbers.
    pub(super) fn numbers<const N: usize>(&self, key: &str, notes: &mut Notes) -> Option<[f64; N]> {
        let list = self.list(key, notes)?;
        let count = list.len();
        let numbers = list.try_into().ok();
        if numbers.is_none() {
            let what = format!("{key} of {} has {count} numbers instead of {N}", self.title());
            notes.mistake(self.line, what, format!("write {N} numbers"));
        }
        numbers
    }

    /// One number.
    pub(super) fn number(&self, key: &str, notes: &mut Notes) -> Option<f64> {
        self.numbers::<1>(key, notes).map(|[number]| number)
    }

    /// The number of another statement.
    pub(super) fn reference(&self, key: &str, notes: &mut Notes) -> Option<u32> {
        let (line, text) = self.text(key)?;
        let id = text.trim().parse().ok();
        if id.is_none() {
            let what = format!("{key} of {} is no identifier: {}", self.title(), shortened(text));
            notes.mistake(line, what, "write the number of a statement");
        }
        id
    }

    /// Keys that nobody has asked for, with their lines.
    pub(super) fn unused(&self) -> impl Iterator<Item = (usize, String)> {
        let unused = self.arguments.iter().filter(|argument| !argument.used.get());
        unused.map(|argument| {
            let value = argument.value.as_deref().map(|value| format!(" = {}", shortened(value)));
            (argument.line, format!("{}{}", shortened(&argument.key), value.unwrap_or_default()))
        })
    }
}
