//! Bushings: elastic bearings with six components.

use toml::Spanned;

use super::Parts;
use super::law::{ANGLE, Axis, LENGTH};
use crate::mechanism::{
    Acts, Bushing, Curve, Direction, ForceKind, Law, MomentLaw, PointId, RotationMeasure, Triad,
};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

/// The keys and units of the three translations or rotations.
struct Group {
    stiffness: &'static str,
    damping: &'static str,
    preload: &'static str,
    tables: [&'static str; 3],
    axis: Axis,
    damping_quantity: Quantity,
}

const TRANSLATION: Group = Group {
    stiffness: "stiffness",
    damping: "damping",
    preload: "preload",
    tables: ["x", "y", "z"],
    axis: LENGTH,
    damping_quantity: Quantity::Damping,
};

const ROTATION: Group = Group {
    stiffness: "rotational_stiffness",
    damping: "rotational_damping",
    preload: "rotational_preload",
    tables: ["rx", "ry", "rz"],
    axis: ANGLE,
    damping_quantity: Quantity::RotationalDamping,
};

/// Tables by component: x, y, z, rx, ry, rz.
type Tables = [Option<(Spanned<()>, Curve)>; 6];

impl Parts<'_> {
    /// A bushing; `joint` is the point of the joint that it stands for, where it does and that has one.
    pub(crate) fn bushing(
        &self,
        section: &mut Section,
        name: &str,
        joint: Option<PointId>,
        report: &mut Report,
    ) -> Option<ForceKind> {
        let at = if joint.is_some() && section.value("at").is_none() {
            joint
        } else {
            self.point(section, "at", "name the centre of the bushing: `at = \"…\"`", report)
        };
        let axes = self.triad(section, report);
        let [x, y, z, rx, ry, rz] = self.tables(section, name, report);
        let translation = self.laws(section, &TRANSLATION, [x, y, z], report);
        let rotation = self.laws(section, &ROTATION, [rx, ry, rz], report);
        let measures = [
            ("xyz", RotationMeasure::Angles),
            ("rotation-vector", RotationMeasure::RotationVector),
        ];
        let measure =
            section.choice_or("angles", "rotation measure", &measures, measures[0].1, report);
        let laws = [("energy", MomentLaw::Energy), ("torque", MomentLaw::Torque)];
        let moment = section.choice_or("law", "law", &laws, laws[0].1, report);
        Some(ForceKind::Bushing(Box::new(Bushing {
            at: at?,
            axes: axes?,
            translation,
            rotation,
            measure: measure?,
            moment: moment?,
        })))
    }

    /// The axes of the file where a section names none.
    pub(super) fn triad(&self, section: &mut Section, report: &mut Report) -> Option<Triad> {
        let mut axis = |key, default: [f64; 3]| match section.value(key) {
            None => Some(Direction::Fixed(self.axes.to_iso(default))),
            Some(_) => self.direction(section, key, report),
        };
        let (x, z) = (axis("x_axis", [1.0, 0.0, 0.0]), axis("z_axis", [0.0, 0.0, 1.0]));
        Some(Triad { x: x?, z: z? })
    }

    fn tables(&self, section: &mut Section, name: &str, report: &mut Report) -> Tables {
        let mut found: Tables = Default::default();
        let help = "name the components: `tables = { x = [[displacement, force], …], rz = [[angle, torque], …] }`";
        let Some(mut tables) = section.optional_section("tables", help, report) else {
            return found;
        };
        for (k, group) in [TRANSLATION, ROTATION].into_iter().enumerate() {
            for (n, key) in group.tables.into_iter().enumerate() {
                let Some(value) = tables.value(key) else { continue };
                let place = Spanned::new(value.span(), ());
                let rows = tables.optional::<Vec<Spanned<[f64; 2]>>>(key, report);
                let curve = rows.and_then(|rows| self.table(&rows, name, group.axis, report));
                // A wrong table has been noted and counts as given.
                found[3 * k + n] = Some((place, curve.unwrap_or_default()));
            }
        }
        tables.finish(report);
        found
    }

    /// The laws of one group: λ = F(Φ) + c Φ̇ − preload.
    fn laws(
        &self,
        section: &mut Section,
        group: &Group,
        tables: [Option<(Spanned<()>, Curve)>; 3],
        report: &mut Report,
    ) -> [Law; 3] {
        let help = format!("write the three components: `{} = [x, y, z]`", group.stiffness);
        let needed = group.stiffness == "stiffness" && tables.iter().any(Option::is_none);
        let stiffness = if needed {
            section.required::<[f64; 3]>(group.stiffness, &help, report)
        } else {
            section.optional(group.stiffness, report)
        };
        let in_si = |numbers: Option<Spanned<[f64; 3]>>, quantity, report: &mut Report| {
            numbers.map_or([0.0; 3], |numbers| self.all_in_si(&numbers, quantity, report))
        };
        let place = stiffness.as_ref().map(Spanned::span);
        let stiffness = in_si(stiffness, group.axis.stiffness, report);
        let damping = section.optional(group.damping, report);
        let damping = in_si(damping, group.damping_quantity, report);
        let preload = section.optional(group.preload, report);
        let preload = in_si(preload, group.axis.force, report);
        let mut laws: [Law; 3] = Default::default();
        for (k, table) in tables.into_iter().enumerate() {
            let elastic = match table {
                None => Curve::linear(stiffness[k]),
                Some((table, curve)) => {
                    if let (Some(place), true) = (&place, stiffness[k] != 0.0) {
                        let component = group.tables[k];
                        let message = format!("`{component}` has a stiffness and a table");
                        report
                            .mistake(&table.span(), message, "a table")
                            .also(place, "and a stiffness")
                            .help(format!(
                                "write 0 for `{component}` in `{}`, or leave out the table",
                                group.stiffness
                            ));
                    }
                    curve
                }
            };
            laws[k] = Law {
                elastic,
                viscous: Curve::linear(damping[k]),
                // The preload is the force on body j.
                preload: 0.0 - preload[k],
                acts: Acts::Always,
            };
        }
        laws
    }
}
