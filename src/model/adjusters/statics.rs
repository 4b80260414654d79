//! The static state: what the suspension is set to before anything is done with it.

use crate::model::quantity::Quantity;
use crate::model::{Model, suggest};

/// The factors that a static state can ask for, with what they are measured in. They do not depend on
/// how the suspension moves.
pub const STATIC_FACTORS: &[(&str, Quantity)] = &[
    ("toe", Quantity::Angle),
    ("camber", Quantity::Angle),
    ("caster", Quantity::Angle),
    ("kpi", Quantity::Angle),
    ("scrub_radius", Quantity::Length),
    ("mechanical_trail", Quantity::Length),
    ("spring_length", Quantity::Length),
    ("wheel_load", Quantity::Force),
];

/// What the suspension is set to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StaticState {
    /// How much higher (m) the chassis stands above the wheels than the hard points say.
    pub ride_height: f64,
    /// What factors have to be.
    pub targets: Vec<StaticTarget>,
}

/// What one factor has to be in the static state.
#[derive(Clone, Debug, PartialEq)]
pub struct StaticTarget {
    /// The name of the factor, one of [`STATIC_FACTORS`].
    pub factor: &'static str,
    /// What it is measured in.
    pub quantity: Quantity,
    /// The value (SI).
    pub value: f64,
    /// The adjuster that sets it, by its place in [`Model::adjusters`].
    pub by: usize,
}

impl Model {
    /// Gives the ride height, a target of the static state or the setting of an adjuster another value, in
    /// the units of the model.
    ///
    /// # Errors
    /// What is wrong with the name or the value, and what to do.
    pub fn set_static(&mut self, name: &str, value: f64) -> Result<(), String> {
        let units = self.units;
        if !value.is_finite() {
            return Err(format!("the value of `{name}` is not a finite number; give a finite one"));
        }
        if name == "ride_height" {
            self.static_state.ride_height = units.length.to_metres(value);
            return Ok(());
        }
        let targets = &mut self.static_state.targets;
        if let Some(target) = targets.iter_mut().find(|target| target.factor == name) {
            target.value = target.quantity.to_si(units, value);
            return Ok(());
        }
        if let Some(index) = self.adjusters.iter().position(|adjuster| adjuster.name == name) {
            if let Some(target) = targets.iter().find(|target| target.by == index) {
                return Err(format!(
                    "`{name}` is what sets `{}`; set `{}` instead, or take it out of [static]",
                    target.factor, target.factor
                ));
            }
            let adjuster = &mut self.adjusters[index];
            adjuster.setting = units.length.to_metres(value);
            let [least, most] = adjuster.limits;
            if !(least..=most).contains(&adjuster.setting) {
                let [least, most] = adjuster.limits.map(|limit| units.length.from_metres(limit));
                let unit = units.length.symbol();
                return Err(format!(
                    "`{name}` goes from {least} to {most} {unit}; give a value between, or other `limits` in the model"
                ));
            }
            return Ok(());
        }
        if STATIC_FACTORS.iter().any(|(factor, _)| *factor == name) {
            return Err(format!(
                "no adjuster of the model sets `{name}`; add `{name} = {{ value = …, by = \"…\" }}` to its [static]"
            ));
        }
        let targets = targets.iter().map(|target| target.factor);
        let known = targets.chain(self.adjusters.iter().map(|adjuster| adjuster.name.as_str()));
        let known: Vec<&str> = ["ride_height"].into_iter().chain(known).collect();
        Err(format!(
            "nothing of the model that can be set is called `{name}`; {}",
            suggest::choices(name, &known)
        ))
    }
}
