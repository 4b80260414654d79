//! What the rig asks of a state: how bodies move with the drivers, and how wheels give way to loads.
//!
//! All of it comes from one factorisation of the matrix at the state. The usual other way is to go to
//! neighbouring states and to look at what has changed.

mod common;

use std::hint::black_box;

use common::assert_same;
use common::measure::{Way, compare, criterion};
use hardpoint::mechanism::DriverId;
use hardpoint::model::{Model, Setup, Side, WheelSupport};
use hardpoint::rig::{Axle, Load, LoadPoint, RigError, Stand};
use hardpoint::solve::Tolerances;
use hardpoint::solve::equilibrium::Equilibrium;

/// Step of a driver (m) for central differences: their error is about 1e-8 of the derivative.
const STEP: f64 = 1e-5;

/// What differences have to agree to, relative to the largest number.
const AGREED: f64 = 1e-5;

const SIDES: [Side; 2] = [Side::Left, Side::Right];

/// The axle without tyres, so that no more than the rig carries its wheels.
fn axle_model() -> Model {
    let text = std::fs::read_to_string("models/sedan-axle.toml").expect("the model is shipped");
    let start = text.find("[tyre]").expect("the axle has tyres");
    let end = text.find("[[forces]]").expect("the axle has a spring");
    let text = format!("{}{}", &text[..start], &text[end..]);
    Model::parse("sedan-axle.toml", &text).expect("the model is sound")
}

/// A mechanism that follows its equilibrium, and its drivers.
struct Rig {
    stand: Stand,
    drivers: Vec<DriverId>,
    /// Where the first drivers go in a sweep; the rack stays.
    travels: usize,
    /// The same mechanism at neighbouring states.
    neighbour: Equilibrium,
    found: Vec<f64>,
}

impl Rig {
    fn corner() -> Self {
        let model = Model::load("models/bushed-double-wishbone.toml").expect("the model is sound");
        let suspension = model.suspension(&Setup::default()).expect("the geometry is sound");
        let drivers = [suspension.travel].into_iter().chain(suspension.rack).collect();
        Self::new(Stand::new(suspension.mechanism, &[], model.axes), drivers, 1)
    }

    fn axle() -> Self {
        let model = axle_model();
        let suspension = model.axle(&Setup::default()).expect("the geometry is sound");
        let drivers = suspension.sides.iter().map(|part| part.travel).chain(suspension.rack);
        let drivers = drivers.collect();
        Self::new(Stand::new(suspension.mechanism, &[], model.axes), drivers, 2)
    }

    fn new(stand: Result<Stand, RigError>, drivers: Vec<DriverId>, travels: usize) -> Self {
        let stand = stand.expect("it moves");
        let neighbour = Equilibrium::new(stand.system());
        let mut rig = Self { stand, drivers, travels, neighbour, found: vec![] };
        rig.go(0.01);
        rig
    }

    fn go(&mut self, travel: f64) {
        let targets: Vec<_> = self.drivers[..self.travels].iter().map(|&d| (d, travel)).collect();
        self.stand.move_to(&targets).expect("within the travel");
    }

    /// Rates of all coordinates by all drivers.
    fn tangents(&mut self) {
        self.found.clear();
        let mut rates = self.stand.rates();
        for &driver in &self.drivers {
            let tangent = rates.tangent(driver).expect("no dead centre");
            self.found.extend_from_slice(tangent.coordinates());
        }
    }

    /// The same with a factorisation for each driver.
    fn tangents_apart(&mut self) {
        self.found.clear();
        for &driver in &self.drivers {
            let mut rates = self.stand.rates();
            let tangent = rates.tangent(driver).expect("no dead centre");
            self.found.extend_from_slice(tangent.coordinates());
        }
    }

    /// The same from equilibria on both sides, by Newton's method alone from the one between them.
    fn differences(&mut self) {
        self.found.clear();
        let (stand, neighbour) = (&self.stand, &mut self.neighbour);
        let center = stand.equilibrium();
        for &driver in &self.drivers {
            let [less, more] = [-STEP, STEP].map(|step| {
                for &driver in &self.drivers {
                    neighbour.set_driver(driver, stand.driver_value(driver));
                }
                neighbour.set_driver(driver, stand.driver_value(driver) + step);
                neighbour.state_mut().copy_from_slice(center.state());
                neighbour.multipliers_mut().copy_from_slice(center.multipliers());
                let outcome = neighbour.solve(&Tolerances::default());
                assert!(outcome.converged(), "{outcome:?}");
                neighbour.state().as_flattened()[7..].to_vec()
            });
            let slopes = less.iter().zip(&more).map(|(less, more)| (more - less) / (2.0 * STEP));
            self.found.extend(slopes);
        }
    }

    /// A sweep of 27 states, −65 … 65 mm, outwards from the design position, with something done at each.
    fn sweep(&mut self, mut at: impl FnMut(&mut Self)) {
        for step in [0.005, -0.005] {
            self.stand.reset();
            for k in 0..=13 {
                self.go(step * f64::from(k));
                // The design position counts once.
                if k > 0 || step > 0.0 {
                    at(self);
                }
            }
        }
    }
}

type Ask = fn(&mut Rig);

fn sweep_ways(rig: fn() -> Rig) -> Vec<Way<'static>> {
    let asks: [(&str, Ask); 4] = [
        ("tangents, one factorisation", Rig::tangents),
        ("tangents, a factorisation each", Rig::tangents_apart),
        ("central differences", Rig::differences),
        ("states alone", |_| ()),
    ];
    let way = |(name, ask): (&'static str, Ask)| -> Way<'static> {
        let mut rig = rig();
        (
            name,
            Box::new(move || {
                rig.sweep(|rig| {
                    ask(rig);
                    black_box(&rig.found);
                });
            }),
        )
    };
    asks.into_iter().map(way).collect()
}

fn state_ways(rig: fn() -> Rig) -> Vec<Way<'static>> {
    let mut expected = rig();
    expected.tangents();
    let expected = expected.found;
    let asks: [(&str, Ask); 3] = [
        ("one factorisation", Rig::tangents),
        ("a factorisation each", Rig::tangents_apart),
        ("central differences", Rig::differences),
    ];
    let way = |(name, ask): (&'static str, Ask)| -> Way<'static> {
        let mut rig = rig();
        ask(&mut rig);
        assert_same(name, &rig.found, &expected, AGREED);
        (name, Box::new(move || ask(black_box(&mut rig))))
    };
    asks.into_iter().map(way).collect()
}

/// The compliance matrix of the axle from finely stepped loads.
struct Cases {
    axle: Axle,
    loads: [Load; 2],
}

impl Cases {
    /// Lets the wheels of an axle go, with what held them as loads.
    fn new(model: &Model, held: &mut Axle) -> Self {
        let setup = Setup { support: WheelSupport::Free, ..Setup::default() };
        let at = LoadPoint::WheelCenter;
        let mut axle = Axle::with_loads(model, &setup, at).expect("it moves");
        let loads = SIDES.map(|side| {
            let load = held.pose(side).load.expect("the axle has forces");
            Load { components: [0.0, 0.0, load.force, 0.0, 0.0, 0.0] }
        });
        axle.set_load(&loads);
        axle.rest().expect("it was in equilibrium");
        Self { axle, loads }
    }

    fn places(&mut self, column: usize, step: f64) -> Vec<f64> {
        let mut loads = self.loads;
        loads[column / 6].components[column % 6] += step;
        self.axle.set_load(&loads);
        self.axle.rest().expect("a small load");
        let state = self.axle.equilibrium().state();
        SIDES.iter().flat_map(|&side| self.axle.pose_at(side, state).wheel.center).collect()
    }

    /// Displacements of both wheel centres, by columns.
    fn run(&mut self) -> Vec<f64> {
        let column = |column: usize| {
            let step = if column % 6 < 3 { 10.0 } else { 2.0 };
            let (less, more) = (self.places(column, -step), self.places(column, step));
            less.iter().zip(&more).map(|(less, more)| (more - less) / (2.0 * step)).collect()
        };
        (0..12).map(column).collect::<Vec<Vec<f64>>>().concat()
    }
}

/// The matrix of an equilibrium without the rows of its travel drivers.
fn without_rows(axle: &Axle) -> Equilibrium {
    let held = axle.equilibrium();
    let drivers = axle.suspension().sides.map(|part| part.travel);
    let mut released = Equilibrium::released(axle.stand().system(), &drivers);
    for driver in axle.stand().mechanism().driver_ids() {
        released.set_driver(driver, held.driver_value(driver));
    }
    released.state_mut().copy_from_slice(held.state());
    released.multipliers_mut().copy_from_slice(held.multipliers());
    released.elements_mut().laws_mut().clone_from_slice(held.elements().laws());
    released
}

fn compliance_ways() -> Vec<Way<'static>> {
    let model = axle_model();
    let [mut axle, template] = [(); 2].map(|()| {
        let mut axle = Axle::new(&model, &Setup::default()).expect("it moves");
        axle.move_to([0.01, -0.005], 0.0).expect("within the travel");
        axle
    });
    let points = axle.suspension().sides.map(|part| (part.wheel.body, part.wheel.center));
    let mut cases = Cases::new(&model, &mut axle);
    let matrix = axle.compliance().expect("springs hold the wheels");
    let expected: Vec<f64> = (0..12)
        .flat_map(|column| [0, 1, 2, 6, 7, 8].map(|row| (row, column)))
        .map(|(row, column)| matrix.entry(row, column))
        .collect();
    assert_same("load cases", &cases.run(), &expected, AGREED);
    let mut planned = without_rows(&axle);
    let anew = planned.compliance(&[], &points).expect("springs hold the wheels");
    let anew: Vec<f64> =
        (0..12).flat_map(|column| [0, 1, 2, 6, 7, 8].map(|row| anew[12 * row + column])).collect();
    assert_same("without rows", &anew, &expected, 1e-9);
    vec![
        (
            "one factorisation, twelve solves",
            Box::new(move || {
                black_box(axle.compliance().expect("springs hold the wheels"));
            }),
        ),
        (
            "a matrix without the rows of the drivers",
            Box::new(move || {
                black_box(planned.compliance(&[], &points).expect("springs hold the wheels"));
            }),
        ),
        (
            "the same, planned each time",
            Box::new(move || {
                black_box(without_rows(&template).compliance(&[], &points).is_ok());
            }),
        ),
        (
            "twenty-four load cases",
            Box::new(move || {
                black_box(cases.run());
            }),
        ),
    ]
}

fn main() {
    let mut criterion = criterion();
    compare(&mut criterion, "compliance of an axle", compliance_ways());
    compare(&mut criterion, "tangents of an axle at a state", state_ways(Rig::axle));
    compare(&mut criterion, "sweep of a bushed corner with its tangents", sweep_ways(Rig::corner));
    criterion.final_summary();
}
