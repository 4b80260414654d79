//! Reads TOML tables key by key and notes every mistake instead of stopping at the first.

mod section;
mod value;

use toml::de::DeTable;

use super::diagnostics::{Report, SourceFile};
pub(crate) use section::{Section, as_section};
pub(crate) use value::FromToml;

/// The only version of the file formats so far.
const FORMAT: f64 = 1.0;

/// Parses the text of a file, notes syntax errors, and hands the outermost table to `read`.
/// A text with syntax errors is not read further: what follows them is not reliable.
pub(crate) fn read_file<T>(
    file: &SourceFile,
    report: &mut Report,
    read: impl FnOnce(&mut Section, &mut Report) -> Option<T>,
) -> Option<T> {
    const START: &str = "start from one of the files in `models/` or `architectures/`";
    read_file_from(START, file, report, read)
}

/// As [`read_file`]; `start` says what to do about an empty file.
pub(crate) fn read_file_from<T>(
    start: &str,
    file: &SourceFile,
    report: &mut Report,
    read: impl FnOnce(&mut Section, &mut Report) -> Option<T>,
) -> Option<T> {
    let (table, errors) = DeTable::parse_recoverable(&file.text);
    if !errors.is_empty() {
        note_syntax_errors(file, &errors, report);
        return None;
    }
    if table.get_ref().is_empty() {
        report.mistake(&(0..0), "the file is empty", "nothing here").help(start);
        return None;
    }
    let mut root = Section::new(None, 0..0, table.get_ref());
    check_format(&mut root, report);
    let result = read(&mut root, report);
    root.finish(report);
    result
}

/// Notes the first error of each line. After a bracket that is never closed
/// everything seems wrong, so then the first error stands alone.
fn note_syntax_errors(file: &SourceFile, errors: &[toml::de::Error], report: &mut Report) {
    let unclosed = errors.iter().any(|e| e.message().contains("unclosed"));
    let mut last_line = None;
    for error in errors {
        let span = error.span().unwrap_or(0..0);
        let before = &file.text[..file.text.floor_char_boundary(span.start)];
        let line = before.matches('\n').count();
        if last_line == Some(line) || (unclosed && last_line.is_some()) {
            continue;
        }
        last_line = Some(line);
        let message = format!("this is not valid TOML: {}", error.message().trim());
        let text = file.text.lines().nth(line).unwrap_or("");
        let hint = syntax_hint(error.message(), text, unclosed);
        report.mistake(&span, message, "here").help(hint);
    }
}

fn syntax_hint(message: &str, line: &str, unclosed: bool) -> &'static str {
    if unclosed {
        "a closing bracket or quote is missing here or on a line before"
    } else if message.contains("duplicate") {
        "keep one of the two"
    } else if line.trim_start().starts_with('[') || !line.contains('=') {
        "a line is `key = value`, a section starts with its name in brackets such as `[points]`"
    } else {
        "texts stand in double quotes, a point is `[x, y, z]`, decimals use a point: 0.5"
    }
}

fn check_format(root: &mut Section, report: &mut Report) {
    let Some(format) = root.required::<f64>("format", "write `format = 1`", report) else {
        return;
    };
    if *format.get_ref() != FORMAT {
        let message = format!("format {} is not supported", format.get_ref());
        let help = "this version of hardpoint reads `format = 1`";
        report.mistake(&format.span(), message, "unknown format").help(help);
    }
}
