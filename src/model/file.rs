//! Reads the text of a model file, still in its own units and axes.

use std::ops::Range;

use toml::Spanned;

use super::axes::{Axes, Side};
use super::diagnostics::Report;
use super::parts::{PointFile, read_points};
use super::read::Section;
use super::units_file::UnitsFile;

/// What a model file says of geometry, as written. What is missing or wrong is `None` and has been noted.
pub(super) struct ModelFile {
    pub(super) name: Option<String>,
    pub(super) description: Option<String>,
    pub(super) source: Option<String>,
    pub(super) architecture: Option<Spanned<String>>,
    pub(super) axes: Option<Spanned<Axes>>,
    pub(super) side: Option<Spanned<Side>>,
    pub(super) units: UnitsFile,
    /// `None` without a `[points]` section.
    pub(super) points: Option<PointsFile>,
    pub(super) wheel: WheelFile,
}

/// The `[points]` section.
pub(super) struct PointsFile {
    pub(super) span: Range<usize>,
    pub(super) entries: Vec<PointFile>,
}

/// The `[wheel]` section.
#[derive(Default)]
pub(super) struct WheelFile {
    pub(super) radius: Option<Spanned<f64>>,
    pub(super) spin: Option<SpinFile>,
}

/// How the spin axis is given.
pub(super) enum SpinFile {
    Alignment { toe: Spanned<f64>, camber: Spanned<f64> },
    Point(Spanned<String>),
}

pub(super) fn read(root: &mut Section, report: &mut Report) -> ModelFile {
    let name = root.required::<String>(
        "name",
        "give the model a name for reports: `name = \"…\"`",
        report,
    );
    let description = root.optional::<String>("description", report);
    let source = root.optional::<String>("source", report);
    let built_in = super::Architecture::built_in_names();
    let architecture_help = format!(
        "name a built-in architecture ({}) or a path that ends in .toml",
        super::suggest::listed(&built_in)
    );
    let architecture = root.required("architecture", &architecture_help, report);
    let axes_hint = ": iso8855 is x forward, y left, z up; adams is x rearward, y right, z up; sae is x forward, y right, z down";
    let axes = root.choice("axes", "axis system", Axes::CHOICES, axes_hint, report);
    let side_hint = ": the side of the vehicle that the points describe";
    let side = root.choice("side", "side", Side::CHOICES, side_hint, report);
    let units = UnitsFile::read(root, report);
    let points = points(root, report);
    let wheel = wheel(root, report);
    ModelFile {
        name: name.map(Spanned::into_inner),
        description: description.map(Spanned::into_inner),
        source: source.map(Spanned::into_inner),
        architecture,
        axes,
        side,
        units,
        points,
        wheel,
    }
}

fn points(root: &mut Section, report: &mut Report) -> Option<PointsFile> {
    let help = "add a section `[points]` with lines such as `lca_front = [200.0, 420.0, -270.0]`";
    let section = root.section("points", help, report)?;
    Some(PointsFile { span: section.span(), entries: read_points(&section, report) })
}

fn wheel(root: &mut Section, report: &mut Report) -> WheelFile {
    let help = "add a section `[wheel]` with `radius`, `toe` and `camber`";
    let Some(mut section) = root.section("wheel", help, report) else {
        return WheelFile::default();
    };
    let radius = section.required(
        "radius",
        "write the rolling radius of the tyre: `radius = 300.0`",
        report,
    );
    let spin = spin(&mut section, report);
    section.finish(report);
    WheelFile { radius, spin }
}

fn spin(section: &mut Section, report: &mut Report) -> Option<SpinFile> {
    const HELP: &str = "give `toe` and `camber`, or `spin_axis_point` with the name of a second point on the spin axis, not both";
    let has = |key| section.has(key);
    let (by_angles, by_point) = (has("toe") || has("camber"), has("spin_axis_point"));
    if by_angles == by_point {
        let (message, label) = match by_point {
            true => ("the spin axis is given twice", "by angles and by a point"),
            false => ("[wheel] lacks the direction of the spin axis", "in this section"),
        };
        let span = match section.value("spin_axis_point") {
            Some(point) => point.span(),
            None => section.span(),
        };
        report.mistake(&span, message, label).help(HELP);
        section.value("toe");
        section.value("camber");
        return None;
    }
    if by_point {
        section.value("toe");
        section.value("camber");
        return section.optional("spin_axis_point", report).map(SpinFile::Point);
    }
    section.value("spin_axis_point");
    let toe = section.required("toe", "write the static toe, positive toe-in: `toe = 0.0`", report);
    let camber = section.required(
        "camber",
        "write the static camber, positive with the top outboard: `camber = 0.0`",
        report,
    );
    Some(SpinFile::Alignment { toe: toe?, camber: camber? })
}
