//! A subsystem of Adams/Car: the hard points of the left side in its axes, and the static angles.

use std::fmt::Write as _;

use super::{Exported, Suspension};
use crate::import::{adams_name, of_architecture};
use crate::model::{AngleUnit, Axes, ForceUnit, LengthUnit, MassUnit, Side};

pub(super) fn write(suspension: &Suspension) -> Exported {
    let architecture = suspension.text(&["architecture"]);
    let (template, is_shared) = of_architecture(architecture);
    let role = suspension.model.vehicle.axle.map_or("any", |axle| axle.name());
    let mut text = String::new();
    block(
        &mut text,
        "MDI_HEADER",
        &[("FILE_TYPE", "'sub'"), ("FILE_VERSION", "4.0"), ("FILE_FORMAT", "'ASCII'")],
    );
    let database = if is_shared { "acar_shared" } else { "private" };
    let path = format!("'mdids://{database}/templates.tbl/{template}.tpl'");
    let role = format!("'{role}'");
    let header =
        [("TEMPLATE_NAME", path.as_str()), ("MAJOR_ROLE", "'suspension'"), ("MINOR_ROLE", &role)];
    block(&mut text, "SUBSYSTEM_HEADER", &header);
    block(&mut text, "UNITS", &units(suspension));
    block(&mut text, "HARDPOINT", &[]);
    let _ = writeln!(text, "{{hardpoint_name  symmetry  x_value  y_value  z_value}}");
    for (name, position) in suspension.points() {
        let roles = suspension.model.architecture.points();
        let is_single =
            position[1] == 0.0 || roles.iter().any(|role| role.name == name && role.may_cross);
        let [x, y, z] = left(suspension, position, is_single);
        let symmetry = if is_single { "single" } else { "left/right" };
        let name = adams_name(architecture, name);
        let _ = writeln!(text, " '{name:<24}'  '{symmetry:<10}'  {x:?}  {y:?}  {z:?}");
    }
    block(&mut text, "PARAMETER", &[]);
    let _ = writeln!(text, "{{parameter_name  symmetry  type  value}}");
    for (name, angle) in angles(suspension) {
        let _ = writeln!(text, " '{name:<24}'  'left/right'  'real'  {angle:?}");
    }
    let mut left_out = suspension.other_sections(&["points", "units", "wheel"]);
    left_out.push("the wheel radius: in Adams/Car it belongs to the wheel subsystem".to_owned());
    if !is_shared {
        left_out.push(format!(
            "bodies and joints: in Adams/Car they belong to the template; `{template}.tpl` with these hard points is \
             one of your own"
        ));
    }
    Exported { text, left_out }
}

fn block(text: &mut String, name: &str, keys: &[(&str, &str)]) {
    // Writing into a text cannot fail.
    let _ = writeln!(text, "${name:->79}\n[{name}]");
    for (key, value) in keys {
        let _ = writeln!(text, " {key:<14} = {value}");
    }
}

fn units(suspension: &Suspension) -> [(&'static str, &'static str); 5] {
    let units = suspension.model.units;
    let length = match units.length {
        LengthUnit::Millimetre => "'mm'",
        LengthUnit::Centimetre => "'cm'",
        LengthUnit::Metre => "'meter'",
        LengthUnit::Inch => "'inch'",
    };
    let angle = match units.angle {
        AngleUnit::Degree => "'degrees'",
        AngleUnit::Radian => "'radians'",
    };
    let force = match units.force {
        ForceUnit::Newton => "'newton'",
        ForceUnit::Kilonewton => "'knewton'",
        ForceUnit::PoundForce => "'pound_force'",
    };
    let mass = match units.mass {
        MassUnit::Kilogram => "'kg'",
        MassUnit::Gram => "'gram'",
        MassUnit::Tonne => "'tonne'",
        MassUnit::Pound => "'pound_mass'",
    };
    [("LENGTH", length), ("ANGLE", angle), ("FORCE", force), ("MASS", mass), ("TIME", "'second'")]
}

/// A point of the file as Adams/Car has it: x rearward, y right, z up, on the left side; one that both sides have
/// together stays where it is.
fn left(suspension: &Suspension, position: [f64; 3], is_single: bool) -> [f64; 3] {
    let model = suspension.model;
    let (from, to) = (model.axes.signs(), Axes::Adams.signs());
    let mirrors = model.side == Side::Right && !is_single;
    let mirror = [1.0, if mirrors { -1.0 } else { 1.0 }, 1.0];
    // Adding zero turns −0 into 0.
    std::array::from_fn(|axis| position[axis] * from[axis] * to[axis] * mirror[axis] + 0.0)
}

/// Toe and camber in the unit of the file: as it has them, or those of the spin axis that points give.
fn angles(suspension: &Suspension) -> [(&'static str, f64); 2] {
    let written = |key| suspension.number(&["wheel", key]);
    let alignment = suspension.model.alignment();
    let unit = suspension.model.units.angle;
    [
        ("toe_angle", written("toe").unwrap_or_else(|| unit.from_radians(alignment.toe))),
        ("camber_angle", written("camber").unwrap_or_else(|| unit.from_radians(alignment.camber))),
    ]
}
