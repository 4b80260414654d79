//! Reads `[static]`.

use toml::Spanned;

use super::read::AdjustersFile;
use super::{Adjuster, STATIC_FACTORS, StaticState, StaticTarget};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;
use crate::model::suggest;

impl AdjustersFile<'_> {
    /// The static state, without targets that have mistakes.
    pub(super) fn static_state(
        &self,
        root: &mut Section,
        adjusters: &[(Spanned<String>, Option<Adjuster>)],
        report: &mut Report,
    ) -> StaticState {
        let help = "write a section `[static]` with lines such as `toe = { value = 0.1, by = \"tie_rod_length\" }`";
        let Some(mut section) = root.optional_section("static", help, report) else {
            return StaticState::default();
        };
        let ride_height =
            self.parts.optional_number(&mut section, "ride_height", Quantity::Length, report);
        let mut targets: Vec<(StaticTarget, Spanned<String>)> = vec![];
        for &(factor, quantity) in STATIC_FACTORS {
            let help = format!(
                "write the value and the adjuster that sets it: `{factor} = {{ value = …, by = \"…\" }}`"
            );
            let Some(mut target) = section.optional_section(factor, &help, report) else {
                continue;
            };
            let value = self.parts.number(&mut target, "value", quantity, &help, report);
            let by = target.required::<String>("by", &help, report);
            target.finish(report);
            let Some((index, by)) = by.and_then(|by| Some((adjuster(&by, adjusters, report)?, by)))
            else {
                continue;
            };
            if let Some((other, place)) = targets.iter().find(|(target, _)| target.by == index) {
                let message = format!("`{}` already sets `{}`", by.get_ref(), other.factor);
                report
                    .mistake(&by.span(), message, "taken")
                    .also(&place.span(), "by this factor")
                    .help("let another adjuster set one of them");
                continue;
            }
            if let Some(value) = value {
                let value = value.into_inner();
                targets.push((StaticTarget { factor, quantity, value, by: index }, by));
            }
        }
        section.finish(report);
        StaticState {
            ride_height: ride_height.map_or(0.0, Spanned::into_inner),
            targets: targets.into_iter().map(|(target, _)| target).collect(),
        }
    }
}

/// The adjuster of a name.
fn adjuster(
    name: &Spanned<String>,
    adjusters: &[(Spanned<String>, Option<Adjuster>)],
    report: &mut Report,
) -> Option<usize> {
    let word = name.get_ref();
    let found = adjusters.iter().position(|(name, _)| name.get_ref() == word);
    if found.is_none() {
        let known: Vec<&str> = adjusters.iter().map(|(name, _)| name.get_ref().as_str()).collect();
        let help = match known[..] {
            [] => format!("add a section `[adjusters.{word}]`"),
            _ => suggest::choices(word, &known),
        };
        report
            .mistake(&name.span(), format!("there is no adjuster `{word}`"), "unknown adjuster")
            .help(help);
    }
    found
}
