//! Lines put together to statements with keys and values.

use std::cell::Cell;

use super::notes::Notes;
use super::statement::{Argument, KEYWORDS, NEW_LINE, Statement, in_full, shortened};

/// The title and the statements of a dataset up to its END.
pub(super) fn statements(text: &str, notes: &mut Notes) -> (String, Vec<Statement>) {
    let mut reader = Reader { pieces: vec![], own: None, name: None, statements: vec![] };
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = text.lines().enumerate();
    let title = lines.next().map_or("", |(_, title)| title);
    let title: String = title.chars().filter(|c| !c.is_control()).collect();
    let (mut goes_on, mut ended) = (false, false);
    for (index, line) in lines {
        let (code, comment) = split_comment(line);
        if let Some(name) = view_name(comment) {
            reader.name = Some(name);
        }
        let code = code.trim();
        if code.is_empty() {
            continue;
        }
        let (code, more) = match code.strip_suffix('&') {
            Some(code) => (code, true),
            None => (code, false),
        };
        let code: String = code.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        match code.strip_prefix(',') {
            Some(rest) => reader.go_on(index + 1, rest, notes),
            None if goes_on => reader.go_on(index + 1, &code, notes),
            None => {
                reader.close(notes);
                ended = reader.statements.last().is_some_and(|last| last.keyword == "END");
                if ended {
                    break;
                }
                reader.pieces = vec![(index + 1, code)];
                reader.own = reader.name.take();
            }
        }
        goes_on = more;
    }
    reader.close(notes);
    ended |= reader.statements.last().is_some_and(|last| last.keyword == "END");
    if !ended {
        let line = text.lines().count().max(1);
        notes.mistake(
            line,
            "the dataset does not end with END",
            "the file may have been cut off: write it anew",
        );
    }
    (title.trim().to_owned(), reader.statements)
}

/// A line before and behind its exclamation mark, which quotes protect.
fn split_comment(line: &str) -> (&str, &str) {
    let mut quote = None;
    for (at, c) in line.char_indices() {
        match (c, quote) {
            ('!', None) => return (&line[..at], &line[at + 1..]),
            ('\'' | '"', None) => quote = Some(c),
            (c, Some(open)) if c == open => quote = None,
            _ => {}
        }
    }
    // A quote that is never closed is an apostrophe.
    match line.find('!').filter(|_| quote.is_some()) {
        Some(at) => (&line[..at], &line[at + 1..]),
        None => (line, ""),
    }
}

/// The name in a comment such as `adams_view_name='PART_2'`.
fn view_name(comment: &str) -> Option<String> {
    let (_, rest) = comment.split_once("adams_view_name")?;
    let name = rest.trim_start().strip_prefix('=')?.trim_start().strip_prefix('\'')?;
    name.split_once('\'').map(|(name, _)| name.to_owned())
}

struct Reader {
    /// The lines of the statement at hand.
    pieces: Vec<(usize, String)>,
    /// Its name.
    own: Option<String>,
    /// The name for the next one.
    name: Option<String>,
    statements: Vec<Statement>,
}

impl Reader {
    fn go_on(&mut self, line: usize, code: &str, notes: &mut Notes) {
        if self.pieces.is_empty() {
            let help = "a line that begins with a comma goes on with a statement before it";
            notes.mistake(line, "this line belongs to no statement", help);
            return;
        }
        self.pieces.push((line, code.to_owned()));
    }

    /// Makes a statement of the lines at hand.
    fn close(&mut self, notes: &mut Notes) {
        let pieces = std::mem::take(&mut self.pieces);
        let Some(&(line, _)) = pieces.first() else { return };
        let lines: Vec<usize> = pieces.iter().map(|(line, _)| *line).collect();
        let text = pieces.into_iter().map(|(_, code)| code).collect::<Vec<_>>();
        let text = text.join(&NEW_LINE.to_string());
        let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let head = text.find(|c| !word(c)).unwrap_or(text.len());
        let (keyword, rest) = text.split_at(head);
        let keyword = keyword.to_ascii_uppercase();
        let full = in_full(&keyword, KEYWORDS).map_or(keyword, str::to_owned);
        let (id, rest) = match rest.trim_start().strip_prefix('/') {
            None => (None, rest),
            Some(rest) => {
                let end = rest.find([',', NEW_LINE, '\\']).unwrap_or(rest.len());
                let id = rest[..end].trim();
                let number: Option<u32> = id.parse().ok();
                // Statements without numbers have their first key there: UNITS/FORCE=NEWTON.
                let key = id.is_empty() || id.contains('=');
                if number.is_none() && !key {
                    let what = format!("`{}` is not the number of a {full}", shortened(id));
                    notes.mistake(line, what, "write a whole number behind the slash");
                }
                (number, if key { rest } else { &rest[end..] })
            }
        };
        let arguments = arguments(rest, &lines);
        self.statements.push(Statement {
            line,
            keyword: full,
            id,
            name: self.own.take(),
            arguments,
        });
    }
}

/// Splits at commas, line ends and backslashes outside of brackets. What has no key of its own goes on with
/// the value before it, unless it is a word.
fn arguments(text: &str, lines: &[usize]) -> Vec<Argument> {
    let mut arguments: Vec<Argument> = vec![];
    let (mut depth, mut piece, mut start) = (0_usize, 0, 0);
    let ends = text.char_indices().chain([(text.len(), ',')]);
    let mut separator = ',';
    for (at, c) in ends {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ',' | '\\' | NEW_LINE if depth == 0 || at == text.len() => {
                let line = lines.get(piece).copied().unwrap_or(lines[0]);
                add(&mut arguments, line, separator, &text[start..at]);
                separator = c;
                start = at + c.len_utf8();
            }
            _ => {}
        }
        if c == NEW_LINE {
            piece += 1;
        }
    }
    arguments
}

fn add(arguments: &mut Vec<Argument>, line: usize, separator: char, text: &str) {
    let text = text.replace(NEW_LINE, " ");
    let text = text.trim();
    if text.is_empty() {
        return;
    }
    let new = |key: &str, value: Option<&str>| Argument {
        line,
        key: key.to_ascii_uppercase(),
        value: value.map(|value| value.trim().to_owned()),
        used: Cell::new(false),
    };
    let is_key = |key: &str| {
        key.starts_with(|c: char| c.is_ascii_alphabetic())
            && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
    };
    if let Some((key, value)) = text.split_once('=')
        && is_key(key.trim())
    {
        arguments.push(new(key.trim(), Some(value)));
        return;
    }
    let Some((key, value)) = arguments
        .last_mut()
        .filter(|_| separator != '\\')
        .and_then(|last| Some((last.key.as_str(), last.value.as_mut()?)))
    else {
        arguments.push(new(text, None));
        return;
    };
    // A formula goes on until its last sign has a right-hand side.
    if is_key(text) && !value.ends_with(['+', '-', '*', '/']) {
        arguments.push(new(text, None));
        return;
    }
    // The comma at the beginning of a line is no part of a formula.
    value.push_str(if is_formula(key) && separator == NEW_LINE { " " } else { ", " });
    value.push_str(text);
}

/// Whether the value of a key is an expression rather than a list.
fn is_formula(key: &str) -> bool {
    let component = key.len() == 2
        && key.starts_with(['F', 'T'])
        && key.ends_with(['1', '2', '3', '4', '5', '6', '7', '8', 'X', 'Y', 'Z']);
    component || key.starts_with("FUN")
}
