//! From the text of a model file to [`Model`]: names to roles, units to SI, axes to ISO 8855.

use std::ops::Range;

use toml::Spanned;

use super::adjusters::AdjustersFile;
use super::alignment::Alignment;
use super::architecture::Architecture;
use super::axes::{Axes, Side};
use super::checks::{self, Geometry};
use super::diagnostics::Report;
use super::file::{ModelFile, PointsFile, SpinFile};
use super::loads_file::LoadsFile;
use super::names::{Names, Unavailable};
use super::parts::Parts;
use super::read::Section;
use super::units::{AngleUnit, Units};
use super::{Model, NamedPoint, SpinAxis, Vehicle, fittings, load, suggest, vehicle};

/// A point of the file under its role, in the units and axes of the file.
struct Placed {
    name: String,
    span: Range<usize>,
    position: [f64; 3],
}

pub(super) fn resolve(root: &mut Section, file: ModelFile, report: &mut Report) -> Option<Model> {
    let mut architecture =
        file.architecture.as_ref().and_then(|name| load::architecture(name, report));
    let mut names = names(architecture.as_ref(), file.points.as_ref());
    let axes = file.axes.as_ref().map(|axes| *axes.get_ref());
    let shown = axes.unwrap_or(Axes::Iso8855);
    let parts = Parts { names: &names, units: &file.units, axes: shown, own_numbers: true };
    let fittings = fittings::fit(root, &parts, architecture.as_mut(), report);
    if let Some(architecture) = &architecture {
        names.set_bodies(architecture.bodies().iter().map(|body| body.name.clone()).collect());
    }
    let parts = Parts { names: &names, units: &file.units, axes: shown, own_numbers: true };
    let joints = architecture.as_ref().map_or(&[][..], |architecture| &architecture.joints);
    let loads = LoadsFile::read(root, &parts, joints, fittings.bushings, report);
    let vehicle = vehicle::read(root, &parts, report);
    let (adjusters, static_state) = {
        let known = architecture.as_ref();
        let file = AdjustersFile {
            parts: &parts,
            joints,
            bushed: loads.bushed().collect(),
            forces: loads.forces().collect(),
            is_shared: &|body| known.is_some_and(|known| known.is_shared(body)),
            body_name: &|body| known.map_or("", |known| known.body_name(body)).to_owned(),
        };
        file.read(root, report)
    };
    let points = match (&architecture, &file.points) {
        (Some(architecture), Some(points)) => place(architecture, &names, points, report),
        _ => None,
    };
    let spin = match (&file.wheel.spin, file.units.angle()) {
        (Some(SpinFile::Alignment { toe, camber }), Some(unit)) => {
            alignment(toe, camber, unit, report)
        }
        (Some(SpinFile::Point(name)), _) => spin_point(name, file.points.as_ref(), report),
        _ => None,
    };
    let units = file.units.units()?;
    let radius = file.wheel.radius.as_ref()?;
    let (axes, side) = (axes?, file.side.as_ref()?);
    let (architecture, points, spin) = (architecture?, points?, spin?);

    let (points, spans) = to_si(&points, units, axes);
    let carried = loads.loads(&architecture, units.length.to_metres(*radius.get_ref()));
    let vehicle = vehicle?;
    // A quarter car says the same of its only wheel.
    let sprung_mass = vehicle.sprung_mass.or(carried.sprung_mass);
    let rack_per_radian = fittings.steering.and_then(|steering| steering.rack_per_radian);
    let mut model = Model {
        name: file.name?,
        description: file.description,
        source: file.source,
        axes,
        units,
        side: *side.get_ref(),
        wheel_radius: units.length.to_metres(*radius.get_ref()),
        spin,
        vehicle: Vehicle { rack_per_radian, sprung_mass, ..vehicle },
        steering: fittings.steering,
        other: None,
        points,
        loads: carried,
        adjusters,
        static_state,
        architecture,
    };
    if let Some(bearing) = fittings.hub_bearing {
        bearing.attach(&mut model);
    }
    let spin_span = match &file.wheel.spin {
        Some(SpinFile::Point(name)) => name.span(),
        _ => radius.span(),
    };
    let geometry = Geometry {
        model: &model,
        points: spans,
        side: side.span(),
        length: file.units.length.as_ref()?.span(),
        radius: radius.span(),
        spin: spin_span,
        loads: loads.places(),
    };
    checks::check(&geometry, report);
    Some(model)
}

/// What forces may name. The points that the architecture requires come first, then the optional ones
/// that the file has, then those that are the model's own; they keep these numbers.
fn names(architecture: Option<&Architecture>, file: Option<&PointsFile>) -> Names {
    let entries = file.map_or(&[][..], |file| &file.entries);
    let given = entries.iter().map(|point| point.name.get_ref());
    let Some(architecture) = architecture else {
        return Names::new(String::new(), vec![], given.cloned().collect());
    };
    let optional = architecture.optional_points();
    let required = architecture.points().iter().map(|role| role.name.clone());
    let present =
        optional.iter().map(|role| &role.name).filter(|name| given.clone().any(|g| g == *name));
    let mut points: Vec<String> = required.chain(present.cloned()).collect();
    let own: Vec<String> = given.filter(|name| !points.contains(name)).cloned().collect();
    points.extend(own);
    let absent = optional.iter().filter(|role| !points.contains(&role.name));
    let unavailable = absent.map(|role| Unavailable {
        name: role.name.clone(),
        why: format!("the point `{}` is not in [points]", role.name),
        help: format!("add `{} = [x, y, z]  # {}`", role.name, role.meaning),
    });
    let unavailable = unavailable.collect();
    let bodies = architecture.bodies().iter().map(|body| body.name.clone()).collect();
    Names::new(architecture.ground().to_owned(), bodies, points).with_unavailable(unavailable)
}

/// Puts the points of the file into the order of their numbers. Notes points that are missing,
/// all together, and names that neither the architecture nor a force knows.
fn place(
    architecture: &Architecture,
    names: &Names,
    file: &PointsFile,
    report: &mut Report,
) -> Option<Vec<Placed>> {
    let required: Vec<&str> = architecture.points().iter().map(|p| p.name.as_str()).collect();
    let optional = architecture.optional_points().iter();
    let optional: Vec<&str> = optional.map(|point| point.name.as_str()).collect();
    let given = |name: &str| file.entries.iter().any(|point| point.name.get_ref() == name);
    let mut missing: Vec<&str> = required.iter().copied().filter(|name| !given(name)).collect();
    for point in &file.entries {
        let word = point.name.get_ref().as_str();
        if required.contains(&word) || optional.contains(&word) || names.is_used(word) {
            continue;
        }
        let free = optional.iter().copied().filter(|name| !given(name));
        let meant = suggest::closest(word, missing.iter().copied().chain(free));
        let help = match meant {
            Some(name) => format!("did you mean `{name}`?"),
            None => {
                let may = match optional.as_slice() {
                    [] => String::new(),
                    optional => format!(" {}, or", suggest::listed(optional)),
                };
                format!(
                    "the points are {}, and may be{may} any that a force names",
                    suggest::listed(&required)
                )
            }
        };
        // A point under a misspelt name is one mistake, not two.
        missing.retain(|name| Some(*name) != meant);
        let message = format!("`{}` has no point `{word}`", architecture.title());
        report.mistake(&point.name.span(), message, "unknown point").help(help);
    }
    note_missing(architecture, &missing, file, report);

    // A point without a place would change the numbers of those behind it.
    let placed = names.points().map(|name| {
        let point = file.entries.iter().find(|point| point.name.get_ref() == name)?;
        let position = point.position.as_ref()?;
        let (span, position) = (position.span(), *position.get_ref());
        Some(Placed { name: name.to_owned(), span, position })
    });
    placed.collect()
}

fn note_missing(
    architecture: &Architecture,
    missing: &[&str],
    file: &PointsFile,
    report: &mut Report,
) {
    if missing.is_empty() {
        return;
    }
    let message = match missing.len() {
        1 => format!("the point {} is missing", suggest::listed(missing)),
        many => format!("{many} points are missing: {}", suggest::listed(missing)),
    };
    let roles = architecture.points().iter();
    let lines: Vec<String> = roles
        .filter(|role| missing.contains(&role.name.as_str()))
        .map(|role| format!("{} = [x, y, z]  # {}", role.name, role.meaning))
        .collect();
    report
        .mistake(&file.span, message, "in this section")
        .help(format!("add\n{}", lines.join("\n")));
}

fn to_si(points: &[Placed], units: Units, axes: Axes) -> (Vec<NamedPoint>, Vec<Range<usize>>) {
    let convert = |point: &Placed| NamedPoint {
        name: point.name.clone(),
        position: axes.to_iso(point.position.map(|x| units.length.to_metres(x))),
    };
    let spans = points.iter().map(|point| point.span.clone()).collect();
    (points.iter().map(convert).collect(), spans)
}

fn alignment(
    toe: &Spanned<f64>,
    camber: &Spanned<f64>,
    unit: AngleUnit,
    report: &mut Report,
) -> Option<SpinAxis> {
    /// No wheel of a road vehicle stands further from straight than this (rad).
    const LARGEST: f64 = std::f64::consts::FRAC_PI_4;
    let mut plausible = true;
    for (name, angle) in [("toe", toe), ("camber", camber)] {
        if unit.to_radians(*angle.get_ref()).abs() < LARGEST {
            continue;
        }
        plausible = false;
        let help = match unit {
            AngleUnit::Radian => {
                "angles are in radians here; for degrees write `angle = \"deg\"` in [units]"
            }
            AngleUnit::Degree => "a static angle of a wheel is a few degrees at most",
        };
        let message = format!("the static {name} is 45° or more");
        report.mistake(&angle.span(), message, "too large").help(help);
    }
    plausible.then(|| {
        SpinAxis::Alignment(Alignment {
            toe: unit.to_radians(*toe.get_ref()),
            camber: unit.to_radians(*camber.get_ref()),
        })
    })
}

fn spin_point(
    name: &Spanned<String>,
    points: Option<&PointsFile>,
    report: &mut Report,
) -> Option<SpinAxis> {
    let word = name.get_ref().as_str();
    let entries = &points?.entries;
    let names: Vec<&str> = entries.iter().map(|point| point.name.get_ref().as_str()).collect();
    if !names.contains(&word) {
        let message = format!("there is no point `{word}` in [points]");
        let help = match suggest::closest(word, names.iter().copied()) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!("add it to [points]: `{word} = [x, y, z]`"),
        };
        report.mistake(&name.span(), message, "unknown point").help(help);
        return None;
    }
    Some(SpinAxis::Point(word.to_owned()))
}

impl Side {
    /// Where y of this side lies in the given axes, for messages.
    pub(super) fn y_rule(self, axes: Axes) -> String {
        let positive = self.sign() * axes.signs()[1] > 0.0;
        let sign = if positive { "positive" } else { "negative" };
        format!("in `{}` axes y is {sign} on the {}", axes.name(), self.name())
    }
}
