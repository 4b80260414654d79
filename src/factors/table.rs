//! The table of all factors.

use thiserror::Error;

use super::definition::Factor;
use super::{
    anti, centers, jacking, lateral, longitudinal, pitch, place, rates, ratios, ride, roll,
    roll_center, steer_axis, steering, travel, wheel,
};
use crate::model::suggest;

/// The parts of the table, in the order of reports.
const PARTS: &[&[Factor]] = &[
    place::DRIVES,
    &place::WHEEL_CENTER,
    &place::CONTACT_PATCH,
    place::CHANGES,
    wheel::ANGLES,
    &wheel::SPIN_AXIS,
    &wheel::ROTATION,
    &steer_axis::THROUGH_JOINTS,
    &steer_axis::AT_HEIGHT,
    &[steer_axis::VIRTUAL_PITCH],
    &steer_axis::AT_SPRING_LENGTH,
    &[steer_axis::VIRTUAL_SPRING_PITCH],
    travel::GRADIENTS,
    &travel::CENTER_VELOCITY,
    &travel::ANGULAR_VELOCITY,
    &travel::PATCH_VELOCITY,
    &travel::PATCH_PATH,
    &travel::SCREW_DIRECTION,
    &travel::SCREW_POINT,
    travel::SCREW_PITCH,
    centers::VIEWS[0],
    centers::VIEWS[1],
    centers::VIEWS[2],
    centers::VIEWS[3],
    centers::VIEWS[4],
    centers::VIEWS[5],
    anti::ROLL_CENTER,
    roll_center::ELASTIC,
    anti::ANTI,
    &ratios::SPRING,
    &ratios::DAMPER,
    place::LOAD,
    steering::STEERING,
    roll::ROLL,
    rates::VERTICAL_RATES,
    rates::ROLL_RATES,
    rates::STIFFNESSES,
    ride::RIDE,
    ride::ROLL,
    &lateral::DEFLECTION,
    &lateral::PATCH_DEFLECTION,
    &lateral::STEER,
    &lateral::CAMBER,
    &lateral::TORQUE_STEER,
    &lateral::TORQUE_CAMBER,
    longitudinal::TRACTION,
    longitudinal::BRAKING,
    jacking::JACKING,
    pitch::ANTI,
    &pitch::DIVE,
    &pitch::LIFT_BRAKING,
    &pitch::LIFT_DRIVING,
    &pitch::SQUAT,
];

const fn count() -> usize {
    let (mut count, mut part) = (0, 0);
    while part < PARTS.len() {
        count += PARTS[part].len();
        part += 1;
    }
    count
}

static ALL: [Factor; count()] = {
    let mut all = [Factor::BLANK; count()];
    let (mut next, mut part) = (0, 0);
    while part < PARTS.len() {
        let mut row = 0;
        while row < PARTS[part].len() {
            all[next] = PARTS[part][row];
            next += 1;
            row += 1;
        }
        part += 1;
    }
    all
};

/// All factors, grouped by subject.
pub static FACTORS: &[Factor] = &ALL;

/// The factors of a plain sweep: what a rig measures of the wheel, in the order of its columns.
pub const BASIC: [&str; 15] = [
    "travel",
    "rack",
    "steering_wheel_angle",
    "wheel_center_x",
    "wheel_center_y",
    "wheel_center_z",
    "toe",
    "camber",
    "wheel_rot_x",
    "wheel_rot_y",
    "wheel_rot_z",
    "caster",
    "kpi",
    "wheel_load",
    "wheel_rate",
];

/// The factors of [`BASIC`].
pub fn basic() -> impl Iterator<Item = &'static Factor> {
    BASIC.iter().filter_map(|name| FACTORS.iter().find(|factor| factor.name == *name))
}

/// No factor has this name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error(
    "there is no factor `{name}`{}; `hardpoint factors --list` has all names",
    .meant.map_or_else(String::new, |meant| format!("; did you mean `{meant}`?"))
)]
pub struct UnknownFactor {
    /// The name that was asked for.
    pub name: String,
    /// The factor with the most similar name.
    pub meant: Option<&'static str>,
}

/// Factors by other names that people and programs use.
const OTHER_NAMES: &[(&str, &str)] = &[
    ("castor", "caster"),
    ("casterangle", "caster"),
    ("kingpin", "kpi"),
    ("kingpininclination", "kpi"),
    ("sai", "kpi"),
    ("scrub", "scrub_radius"),
    ("trail", "mechanical_trail"),
    ("castertrail", "mechanical_trail"),
    ("rollcenter", "rc_height"),
    ("rollcentre", "rc_height"),
    ("rollcenterheight", "rc_height"),
    ("rollcentreheight", "rc_height"),
    ("rch", "rc_height"),
    ("antibrake", "anti_dive"),
    ("antiroll", "rc_height"),
    ("shockratio", "damper_ratio"),
    ("installationratio", "motion_ratio"),
    ("leverageratio", "spring_ratio"),
    ("toegain", "bump_steer"),
    ("cambergain", "bump_camber"),
    ("castergain", "bump_caster"),
    ("fvsa", "fvsa_length"),
    ("svsa", "svsa_length"),
    ("fvic", "fvic_y"),
    ("svic", "svic_x"),
    ("trackchange", "half_track_change"),
    ("steer", "steer_angle"),
    ("rollstiffness", "roll_rate"),
    ("suspensionrollrate", "roll_rate"),
    ("ridestiffness", "ride_rate"),
    ("tirerate", "tyre_rate"),
    ("treadwidth", "track"),
    ("jackingforce", "jacking_lateral"),
    ("steeringwheel", "steering_wheel_angle"),
    ("handwheel", "steering_wheel_angle"),
    ("overallsteeringratio", "steering_ratio"),
];

/// The factor of a name.
///
/// # Errors
/// [`UnknownFactor`] with what may have been meant.
pub fn find(name: &str) -> Result<&'static Factor, UnknownFactor> {
    if let Some(factor) = FACTORS.iter().find(|factor| factor.name == name) {
        return Ok(factor);
    }
    let plain = suggest::plain(name);
    let other = OTHER_NAMES.iter().find(|(other, _)| *other == plain).map(|(_, ours)| *ours);
    let names = || FACTORS.iter().map(|factor| factor.name);
    let meant = other.or_else(|| suggest::closest(name, names()));
    Err(UnknownFactor { name: name.to_owned(), meant })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factors::Subject;

    #[test]
    fn every_factor_is_fully_stated_and_has_its_own_name() {
        for (index, factor) in FACTORS.iter().enumerate() {
            let Factor { name, title, symbol, sign, formula, source, .. } = *factor;
            for text in [name, title, symbol, sign, formula, source] {
                assert!(!text.is_empty(), "{name}");
                // The table of definitions is one of Markdown.
                assert!(!text.contains(['|', '\n']), "{name}: {text}");
            }
            let word = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
            assert!(name.chars().all(word), "{name}");
            assert!(FACTORS[..index].iter().all(|other| other.name != name), "two {name}");
            assert!(FACTORS[..index].iter().all(|other| other.title != title), "two {title}");
        }
    }

    #[test]
    fn subjects_stand_together() {
        let mut order: Vec<Subject> = FACTORS.iter().map(|factor| factor.subject).collect();
        order.dedup();
        assert_eq!(order, Subject::ALL);
    }

    #[test]
    fn factors_are_found_by_name_and_guessed_otherwise() {
        assert_eq!(find("toe").map(|factor| factor.name), Ok("toe"));
        let meant = |name| find(name).err().and_then(|unknown| unknown.meant);
        assert_eq!(meant("cambr"), Some("camber"));
        assert_eq!(meant("Roll-Centre"), Some("rc_height"));
        assert_eq!(meant("qqq"), None);
        assert!(OTHER_NAMES.iter().all(|(_, ours)| find(ours).is_ok()));
        assert_eq!(basic().count(), BASIC.len());
    }
}
