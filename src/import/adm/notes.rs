//! What was found on the way: mistakes, what cannot be taken over, and what was assumed.

use crate::import::{ImportError, LeftOut, Mistakes};

/// Gathers notes, so that all are told at once.
pub(super) struct Notes {
    mistakes: Mistakes,
    lenient: bool,
    pub(super) left_out: Vec<LeftOut>,
    pub(super) assumed: Vec<String>,
    count: usize,
}

/// More mistakes than this say nothing new.
const MOST: usize = 100;

impl Notes {
    pub(super) fn new(name: &str, text: &str, lenient: bool) -> Self {
        let mistakes = Mistakes::new(name, text);
        Self { mistakes, lenient, left_out: vec![], assumed: vec![], count: 0 }
    }

    /// Something without which there is no mechanism.
    pub(super) fn mistake(
        &mut self,
        line: usize,
        what: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.count += 1;
        if self.count <= MOST {
            self.mistakes.note(line, what, help);
        }
    }

    /// A part that changes the mechanism and cannot be taken over.
    pub(super) fn missing(&mut self, line: usize, what: impl Into<String>, why: impl Into<String>) {
        if self.lenient {
            self.left_out(line, what, why);
            return;
        }
        let (what, why): (String, String) = (what.into(), why.into());
        let help = format!("{why}; with --lenient it is left out and the mechanism is another one");
        self.mistake(line, format!("{what} cannot be taken over"), help);
    }

    /// Something that is not taken over and does not change the mechanism.
    pub(super) fn left_out(
        &mut self,
        line: usize,
        what: impl Into<String>,
        why: impl Into<String>,
    ) {
        self.left_out.push(LeftOut { line, what: what.into(), why: why.into() });
    }

    /// Statements of one kind that are not taken over.
    pub(super) fn left_out_together(&mut self, keyword: &str, lines: &[usize], why: &str) {
        let what = match lines {
            [] => return,
            [_] => keyword.to_owned(),
            _ => {
                let lines: Vec<String> = lines.iter().map(usize::to_string).collect();
                format!("{} {keyword}, lines {}", lines.len(), lines.join(", "))
            }
        };
        self.left_out(lines[0], what, why);
    }

    /// What the dataset does not say.
    pub(super) fn assume(&mut self, what: impl Into<String>) {
        self.assumed.push(what.into());
    }

    /// Whether there is a mistake.
    pub(super) fn any_mistakes(&self) -> bool {
        self.count > 0
    }

    pub(super) fn finish(mut self) -> Result<(Vec<LeftOut>, Vec<String>), ImportError> {
        self.mistakes.finish()?;
        self.left_out.sort();
        Ok((self.left_out, self.assumed))
    }
}
