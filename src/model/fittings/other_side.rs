//! `other_side`: a file of its own for the other side of the vehicle.

use std::path::Path;

use toml::Spanned;

use crate::model::axle::difference;
use crate::model::diagnostics::Report;
use crate::model::{Model, Side, load};

/// The model that a file names as its other side. Mistakes in it are added to the report.
pub(in crate::model) fn read(named: &Spanned<String>, report: &mut Report) -> Option<Model> {
    let model = Path::new(&report.file().name);
    let path = model.parent().unwrap_or(Path::new("")).join(named.get_ref());
    match load::read_text(&path) {
        Ok(text) => match load::alone(&path.display().to_string(), &text) {
            Ok(model) => Some(model),
            Err(diagnostics) => {
                report.mistakes.extend_from_slice(diagnostics.mistakes());
                None
            }
        },
        Err((message, help)) => {
            let help = format!("{help}; the path is relative to the model file");
            report.mistake(&named.span(), message, "the other side").help(help);
            None
        }
    }
}

/// Joins a model and its other side, or notes why they are no pair.
pub(in crate::model) fn join(
    model: &mut Model,
    other: Model,
    named: &Spanned<String>,
    report: &mut Report,
) {
    let pair = match model.side {
        Side::Left => [&*model, &other],
        Side::Right => [&other, &*model],
    };
    let gravity = (other.gravity() != model.gravity() && other.gravity() != 0.0)
        .then(|| "they have different gravity".to_owned());
    if let Some(difference) = difference(pair).or(gravity) {
        let path = named.get_ref();
        let message = format!("`{path}` is not the other side of this model: {difference}");
        report.mistake(&named.span(), message, "the other side").help(
            "give both files one architecture and the same [steering], [hub_bearing], [subframe] and \
             [anti_roll_bar], one file for the left and one for the right; or leave out `other_side`, and \
             the other side is the mirror image",
        );
        return;
    }
    model.other = Some(Box::new(other));
}
