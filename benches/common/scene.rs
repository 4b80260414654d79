//! The suspension that is measured: the sedan's double wishbone.

use hardpoint::assembly::{Jacobian, Kkt, Numbering, Pattern, Terms};
use hardpoint::mechanism::{DriverId, Expansion, Mechanism};
use hardpoint::model::{Model, Setup};
use hardpoint::relation::Coordinates;
use hardpoint::solve::System;

/// The sedan away from its design position, with forces in its joints.
pub struct Scene {
    pub mechanism: Mechanism,
    pub travel: DriverId,
    pub expansion: Expansion,
    pub terms: Terms,
    pub numbering: Numbering,
    /// The pattern of Φ_q.
    pub phi_q: Pattern,
    /// The pattern of the matrix of static equilibrium.
    pub kkt: Pattern,
    /// Coordinates at 60 mm of travel and 10 mm of rack.
    pub state: Vec<Coordinates<f64>>,
    /// Parameters there.
    pub h: Vec<f64>,
    /// A multiplier for every equation.
    pub lambda: Vec<f64>,
}

impl Scene {
    /// Reads the model and moves it.
    pub fn sedan() -> Self {
        let model = Model::load("models/double-wishbone.toml").expect("the model is sound");
        let suspension = model.suspension(&Setup::default()).expect("the geometry is sound");
        let rack = suspension.rack.expect("the sedan steers");
        let mut system = System::new(suspension.mechanism.clone()).expect("the sedan moves");
        assert!(system.freedom().is_exact(), "{}", system.freedom());
        system.move_to(&[(suspension.travel, 0.06), (rack, 0.01)]).expect("within the travel");

        let expansion = system.expansion().clone();
        let terms = Terms::new(&expansion);
        let numbering = Numbering::new(&expansion, &[]);
        let mut random = fastrand::Rng::with_seed(7);
        Self {
            phi_q: Jacobian::new(terms.clone(), &numbering).pattern().clone(),
            kkt: Kkt::new(terms.clone(), &numbering).pattern().clone(),
            state: system.state().to_vec(),
            h: system.parameters().to_vec(),
            lambda: (0..expansion.equation_count()).map(|_| 2.0 * random.f64() - 1.0).collect(),
            mechanism: suspension.mechanism,
            travel: suspension.travel,
            expansion,
            terms,
            numbering,
        }
    }
}
