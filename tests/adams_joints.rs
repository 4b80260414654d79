//! Single joints and springs in motion against histories of ADAMS.
//!
//! The histories come from Project Chrono's tests. A few rows are in `reference/adams-joints.csv`; all
//! rows up to 1 s are compared where the full set is beside the repository.

#[path = "common/adams.rs"]
mod adams;

use adams::{Row, carried, folder, history, hold};
use hardpoint::mechanism::{
    BodyId, Curve, Direction, ForceId, ForceKind, InitialVelocity, JointKind, Law, MassProperties,
    Mechanism, PointId, Reference, Spline,
};
use hardpoint::solve::dynamics::{Dynamics, Integrator, Start};
use hardpoint::solve::{System, Wrench};

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.80665];
const ORIGIN: [f64; 3] = [0.0; 3];

/// The axes of a marker, as columns, by its body-fixed 3-1-3 angles (°).
type Axes = [[f64; 3]; 3];

fn reuler(angles: [f64; 3]) -> Axes {
    let z = |angle: f64| {
        let (s, c) = angle.to_radians().sin_cos();
        [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
    };
    let (s, c) = angles[1].to_radians().sin_cos();
    let x = [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]];
    product(product(z(angles[0]), x), z(angles[2]))
}

fn product(a: Axes, b: Axes) -> Axes {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn column(axes: Axes, k: usize) -> Direction {
    Direction::Fixed([axes[0][k], axes[1][k], axes[2][k]])
}

/// A body of 1 kg on the ground, before its joint is added.
struct Deck {
    name: &'static str,
    mechanism: Mechanism,
    body: BodyId,
    center: PointId,
    /// Where the joint is.
    at: PointId,
    /// The axes of the markers of joint and centre of mass.
    axes: Axes,
    /// The time of the start (s).
    start: f64,
    /// What the reaction belongs to.
    force: Option<ForceId>,
    /// Joint and force act together.
    both: bool,
}

fn deck(name: &'static str, at: [f64; 3], center: [f64; 3], angles: [f64; 3]) -> Deck {
    let axes = reuler(angles);
    let mut m = Mechanism::new("ground");
    m.set_gravity(GRAVITY).unwrap();
    let body = m.add_body("pendulum", center).unwrap();
    let at = m.add_point("joint", at).unwrap();
    let middle = m.add_point("center", center).unwrap();
    // In the axes of the marker: IP, whose axis with little inertia is that of the bar.
    let principal = if name.starts_with("Universal") { [0.1, 0.1, 0.04] } else { [0.04, 0.1, 0.1] };
    let j = |a: usize, b: usize| -> f64 {
        (0..3).map(|k| axes[a][k] * principal[k] * axes[b][k]).sum()
    };
    let inertia = [j(0, 0), j(1, 1), j(2, 2), j(0, 1), j(0, 2), j(1, 2)];
    m.set_mass(body, MassProperties { mass: 1.0, center, inertia }).unwrap();
    Deck {
        name,
        mechanism: m,
        body,
        center: middle,
        at,
        axes,
        start: 0.0,
        force: None,
        both: false,
    }
}

impl Deck {
    fn joint(mut self, kind: impl Fn(PointId, Direction) -> JointKind) -> Self {
        let kind = kind(self.at, column(self.axes, 2));
        self.mechanism.add_joint("joint", BodyId::GROUND, self.body, kind).unwrap();
        self
    }

    /// A cross between two pins: x of the marker on the ground, y of that on the body.
    fn hooke(mut self) -> Self {
        let m = &mut self.mechanism;
        let cross = m.add_body("cross", ORIGIN).unwrap();
        for (name, i, j, axis) in
            [("first pin", BodyId::GROUND, cross, 0), ("second pin", cross, self.body, 1)]
        {
            let kind = JointKind::Revolute { at: self.at, axis: column(self.axes, axis) };
            m.add_joint(name, i, j, kind).unwrap();
        }
        self
    }

    /// From the joint's point on the ground to a point of the body.
    fn line(mut self, end: [f64; 3], law: Option<(f64, Law)>) -> Self {
        let (on_i, m) = (self.at, &mut self.mechanism);
        let on_j = m.add_point("end", end).unwrap();
        match law {
            None => {
                let link = JointKind::Link { on_i, on_j };
                m.add_joint("link", BodyId::GROUND, self.body, link).unwrap();
            }
            Some((length, law)) => {
                let spring =
                    ForceKind::Line { on_i, on_j, reference: Reference::Length(length), law };
                let force = m.add_force("spring", BodyId::GROUND, self.body, spring).unwrap();
                self.force = Some(force);
            }
        }
        self
    }

    fn torsion(mut self, law: Law) -> Self {
        let spring = ForceKind::Torsion { axis: column(self.axes, 2), law };
        let spring = self.mechanism.add_force("spring", BodyId::GROUND, self.body, spring);
        self.force = Some(spring.unwrap());
        self.both = true;
        self
    }

    fn thrown(mut self, time: f64, velocity: [f64; 3]) -> Self {
        self.start = time;
        let motion = InitialVelocity { velocity, rotation: ORIGIN };
        self.mechanism.set_initial_velocity(self.body, motion).unwrap();
        self
    }
}

fn decks() -> Vec<Deck> {
    let corner = [1.0, 2.0, 3.0];
    let beside = [3.0, 2.0, 3.0];
    let (arm, level) = ([2.0, 0.0, 0.0], [180.0, 90.0, 180.0]);
    let inclined = [180.0, 45.0, 180.0];
    let diagonal = [std::f64::consts::SQRT_2, std::f64::consts::SQRT_2, 0.0];
    let revolute = |at, axis| JointKind::Revolute { at, axis };
    let spherical = |at, _| JointKind::Spherical { at };
    let cylindrical = |at, axis| JointKind::Cylindrical { at, axis };
    let prismatic = |at, axis| JointKind::Translational { at, axis };
    let above = [0.0, 2.0, 0.0];
    let spring =
        |stiffness, damping| Law { viscous: Curve::linear(damping), ..Law::spring(stiffness) };
    // (50 + 10 |θ|) θ as a table, fine enough for the kink of its second derivative at zero.
    let rows = (-100..=500).map(|k| 0.002 * f64::from(k));
    let rows = rows.map(|angle| [angle, (50.0 + 10.0 * angle.abs()) * angle]).collect();
    let progressive =
        Law { elastic: Curve::Table(Spline::new("spring", rows).unwrap()), ..spring(0.0, 10.0) };
    vec![
        deck("Revolute_Case01", ORIGIN, arm, level).joint(revolute),
        deck("Revolute_Case02", corner, beside, inclined).joint(revolute),
        deck("Spherical_Case01", ORIGIN, arm, ORIGIN).joint(spherical),
        deck("Spherical_Case02", corner, beside, inclined).joint(spherical),
        deck("Universal_Case01", ORIGIN, above, [0.0, 90.0, 0.0]).hooke(),
        deck("Universal_Case02", ORIGIN, [-2.0, 0.0, 0.0], [90.0, 90.0, -90.0]).hooke(),
        deck("Universal_Case03", ORIGIN, diagonal, [-45.0, 90.0, 45.0]).hooke(),
        deck("Cylindrical_Case01", ORIGIN, arm, ORIGIN).joint(cylindrical),
        deck("Cylindrical_Case02", ORIGIN, arm, level).joint(cylindrical),
        deck("Cylindrical_Case03", corner, beside, inclined).joint(cylindrical),
        deck("Prismatic_Case01", ORIGIN, arm, ORIGIN).joint(prismatic),
        deck("Prismatic_Case02", corner, beside, inclined).joint(prismatic),
        deck("Prismatic_Case03", corner, beside, level).joint(prismatic),
        deck("Distance_Case01", ORIGIN, above, ORIGIN).line(above, None),
        deck("Distance_Case02", corner, [-1.0, 4.0, 3.0], ORIGIN).line([1.0, 4.0, 3.0], None),
        deck("Distance_Case03", ORIGIN, [0.0, 4.0, 0.0], [-90.0, 0.0, 0.0]).line(above, None),
        // The spring of length zero has no direction at first: from the row at 0.1 s on.
        deck("TranSpring_Case01", ORIGIN, SPRING_START[0], ORIGIN)
            .line(SPRING_START[0], Some((0.0, spring(10.0, 0.5))))
            .thrown(0.1, SPRING_START[1]),
        deck("TranSpring_Case02", ORIGIN, above, ORIGIN)
            .line(above, Some((2.0, spring(100.0, 5.0)))),
        deck("RotSpring_Case01", ORIGIN, arm, level).joint(revolute).torsion(spring(200.0, 10.0)),
        deck("RotSpring_Case02", ORIGIN, arm, level).joint(revolute).torsion(progressive),
    ]
}

/// Position and velocity of TranSpring_Case01 at 0.1 s.
const SPRING_START: [[f64; 3]; 2] = [[0.0, 0.0, -0.0478269], [0.0, 0.0, -0.94069]];

fn observe(deck: &Deck, motion: &Dynamics) -> Row {
    let mut row = [0.0; 25];
    row[..3].copy_from_slice(&motion.point_position(deck.body, deck.center));
    row[3..7].copy_from_slice(&euler_parameters(product(motion.rotation(deck.body), deck.axes)));
    row[7..10].copy_from_slice(&motion.point_velocity(deck.body, deck.center));
    row[10..13].copy_from_slice(&motion.angular_velocity(deck.body));
    row[13..16].copy_from_slice(&motion.point_acceleration(deck.body, deck.center));
    row[16..19].copy_from_slice(&motion.angular_acceleration(deck.body));
    let loaded = motion.loaded();
    let ground = loaded.point(BodyId::GROUND, deck.at);
    // What comes from the ground: the first joint and the spring.
    let mut wrenches: Vec<Wrench> = vec![];
    if deck.force.is_none() || deck.both {
        wrenches.push(motion.reactions()[0].on_j);
    }
    wrenches.extend(deck.force.map(|force| loaded.force(force)));
    for wrench in wrenches {
        let wrench = wrench.about(ground);
        for k in 0..3 {
            row[19 + k] -= wrench.force[k];
            row[22 + k] -= wrench.moment[k];
        }
    }
    row
}

/// Euler parameters of a rotation, the largest first and positive in sign.
fn euler_parameters(a: Axes) -> [f64; 4] {
    let trace = a[0][0] + a[1][1] + a[2][2];
    let squares =
        [trace, a[0][0], a[1][1], a[2][2]].map(|entry| 0.25 * (1.0 + 2.0 * entry - trace));
    let largest = (0..4).max_by(|&i, &j| squares[i].total_cmp(&squares[j])).unwrap();
    let e = squares[largest].sqrt();
    let odd = [a[2][1] - a[1][2], a[0][2] - a[2][0], a[1][0] - a[0][1]];
    let even = [a[2][1] + a[1][2], a[0][2] + a[2][0], a[1][0] + a[0][1]];
    let pair = |i: usize| even[i] / (4.0 * e);
    match largest {
        0 => [e, odd[0] / (4.0 * e), odd[1] / (4.0 * e), odd[2] / (4.0 * e)],
        1 => [odd[0] / (4.0 * e), e, pair(2), pair(1)],
        2 => [odd[1] / (4.0 * e), pair(2), e, pair(0)],
        _ => [odd[2] / (4.0 * e), pair(1), pair(0), e],
    }
}

/// Runs a deck through the times of the reference and holds the differences against what is allowed.
fn compare(deck: &Deck, reference: &[(f64, Row)]) {
    let system = System::new(deck.mechanism.clone()).unwrap();
    // This pendulum on a link is thrown around within hundredths of a second.
    let step = if deck.name == "Distance_Case02" { 2e-5 } else { 1e-4 };
    let mut motion = Dynamics::new(&system, &Start::default(), Integrator::fixed(step)).unwrap();
    let rows = reference.iter().filter(|(time, _)| *time >= deck.start);
    let rows = rows.map(|(time, expected)| {
        motion.advance_to(time - deck.start).unwrap();
        (observe(deck, &motion), *expected)
    });
    hold(deck.name, rows);
}

#[test]
fn a_few_rows_of_every_history() {
    for deck in decks() {
        compare(&deck, &carried(deck.name));
    }
}

#[test]
fn all_rows_up_to_one_second_of_every_history() {
    let Some(folder) = folder() else { return };
    for deck in decks() {
        compare(&deck, &history(&folder, deck.name));
    }
}
