//! Motion in time against published benchmarks of multibody dynamics.

use hardpoint::mechanism::{
    BodyId, Direction, ForceKind, InitialVelocity, JointKind, Law, LoadFrame, MassProperties,
    Mechanism, PointId, Reference,
};
use hardpoint::solve::System;
use hardpoint::solve::dynamics::{Dynamics, Integrator, Start};

const Z: Direction = Direction::Fixed([0.0, 0.0, 1.0]);

fn revolute(at: PointId) -> JointKind {
    JointKind::Revolute { at, axis: Z }
}

fn planar([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

/// Andrews' squeezing mechanism in space: Hairer & Wanner, Solving Ordinary Differential Equations
/// II, section VII.7; test set for IVP solvers, problem Andrews. Its ten hinges are revolute joints.
struct Andrews {
    mechanism: Mechanism,
    bodies: [BodyId; 7],
    /// The angles of the seven bodies at the design position.
    angles: [f64; 7],
}

/// β, Θ, γ, Φ, δ, Ω, ε at the start.
const ANDREWS_START: [f64; 7] = [
    -0.06171389001427645,
    0.0,
    0.45527981916307037,
    0.22266839016588588,
    0.48736497954384256,
    -0.22266839016588588,
    1.2305474445498212,
];

/// The angles of the bodies K1 … K7 by those of the problem.
fn body_angles([b, th, g, ph, de, om, ep]: [f64; 7]) -> [f64; 7] {
    [b, b + th, g, ph + de, de, om + ep, ep]
}

/// The angles of the problem by those of the bodies.
fn problem_angles([k1, k2, k3, k4, k5, k6, k7]: [f64; 7]) -> [f64; 7] {
    [k1, k2 - k1, k3, k4 - k5, k5, k6 - k7, k7]
}

fn andrews() -> Andrews {
    let angles = body_angles(ANDREWS_START);
    // A vector of body k, given in its own axes.
    let turned = |k: usize, [x, y]: [f64; 2]| {
        let (sin, cos) = f64::sin_cos(angles[k - 1]);
        [cos * x - sin * y, sin * x + cos * y]
    };
    let plus = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a + c, b + d];
    let (a, b) = ([-0.06934, -0.00227], [-0.03635, 0.03273]);
    let (e, zt, zf, u) = (0.02, 0.04, 0.02, 0.04);
    let f = turned(1, [0.007, 0.0]);
    let tip = plus(f, turned(2, [-0.028, 0.0]));
    let g = plus(a, turned(5, [zt, 0.0]));
    let h = plus(a, turned(7, [0.0, -u]));
    let centers = [
        turned(1, [0.00092, 0.0]),
        plus(f, turned(2, [-0.0115, 0.0])),
        plus(b, turned(3, [0.01043, -0.01874])),
        plus(g, turned(4, [0.0, -(e - 0.01421)])),
        plus(a, turned(5, [0.02308, 0.00916])),
        plus(h, turned(6, [zf - 0.01421, 0.0])),
        plus(a, turned(7, [-0.00449, -0.01228])),
    ];
    let masses = [0.04325, 0.00365, 0.02373, 0.00706, 0.0705, 0.00706, 0.05498];
    let inertias = [2.194e-06, 4.41e-07, 5.255e-06, 5.667e-07, 1.169e-05, 5.667e-07, 1.912e-05];

    let mut m = Mechanism::new("ground");
    let bodies: [BodyId; 7] = std::array::from_fn(|k| {
        let body = m.add_body(&format!("K{}", k + 1), planar(centers[k])).unwrap();
        // Any moments of inertia about x and y will do, as long as a body can have them.
        let j = inertias[k];
        let inertia = [0.6 * j, 0.6 * j, j, 0.0, 0.0, 0.0];
        let mass = MassProperties { mass: masses[k], center: planar(centers[k]), inertia };
        m.set_mass(body, mass).unwrap();
        body
    });
    let [k1, k2, k3, k4, k5, k6, k7] = bodies;
    let mut point = |name: &str, at| m.add_point(name, planar(at)).unwrap();
    let points = [
        point("O", [0.0; 2]),
        point("F", f),
        point("E", tip),
        point("B", b),
        point("A", a),
        point("G", g),
        point("H", h),
    ];
    let c = point("C", [0.014, 0.072]);
    let d = point("D", plus(b, turned(3, [0.02, -0.018])));
    let [o, f, e, b, a, g, h] = points;
    let ground = BodyId::GROUND;
    for (name, i, j, at) in [
        ("O", ground, k1, o),
        ("F", k1, k2, f),
        ("E3", k3, k2, e),
        ("E4", k4, k2, e),
        ("E6", k6, k2, e),
        ("B", ground, k3, b),
        ("A5", ground, k5, a),
        ("A7", ground, k7, a),
        ("G", k5, k4, g),
        ("H", k7, k6, h),
    ] {
        m.add_joint(name, i, j, revolute(at)).unwrap();
    }
    let law = Law::spring(4530.0);
    let spring = ForceKind::Line { on_i: c, on_j: d, reference: Reference::Length(0.07785), law };
    m.add_force("spring", ground, k3, spring).unwrap();
    let (frame, direction) = (LoadFrame::Space, [0.0, 0.0, 1.0]);
    let motor = ForceKind::Moment { frame, direction, size: 0.033 };
    m.add_force("motor", ground, k1, motor).unwrap();
    Andrews { mechanism: m, bodies, angles }
}

#[test]
fn andrews_begins_with_the_accelerations_and_reactions_of_the_test_set() {
    let andrews = andrews();
    let system = System::new(andrews.mechanism.clone()).unwrap();
    assert_eq!(system.freedom().redundant.len(), 9);
    assert_eq!(system.freedom().degrees_of_freedom, 1);
    let motion = Dynamics::new(&system, &Start::default(), Integrator::fixed(1e-6)).unwrap();
    // β″ and Θ″; all others are zero.
    let (b, th) = (14222.443919954114, -10666.832939965585);
    for (body, expected) in andrews.bodies.into_iter().zip([b, b + th, 0.0, 0.0, 0.0, 0.0, 0.0]) {
        let actual = motion.angular_acceleration(body)[2];
        assert!((actual - expected).abs() < 1e-9 * b, "{actual} and {expected}");
    }
    // λ acts on K2 at E with −λ: once against each of K3, K4 and K6.
    let reactions = motion.reactions();
    let expected: [[f64; 2]; 3] = [[98.56687039624109, -6.122688344255662], [0.0; 2], [0.0; 2]];
    for (reaction, expected) in reactions[2..5].iter().zip(expected) {
        for axis in 0..2 {
            let lambda = -reaction.on_j.force[axis];
            let allowed = 1e-9 * expected[axis].abs().max(0.1);
            assert!((lambda - expected[axis]).abs() < allowed, "{lambda} and {expected:?}");
        }
    }
}

#[test]
fn andrews_ends_in_the_reference_state() {
    let andrews = andrews();
    let system = System::new(andrews.mechanism.clone()).unwrap();
    let run = |step: f64| {
        let mut motion =
            Dynamics::new(&system, &Start::default(), Integrator::fixed(step)).unwrap();
        motion.advance_to(0.03).unwrap();
        andrews.bodies.map(|body| {
            let a = motion.rotation(body);
            [a[1][0].atan2(a[0][0]), motion.angular_velocity(body)[2]]
        })
    };
    let (coarse, fine) = (run(5e-7), run(2.5e-7));
    let positions = [
        15.81077119629904,
        -15.75637105984298,
        0.04082224013073101,
        -0.5347301163226948,
        0.5244099658805303,
        0.5347301163226948,
        1.048080741042263,
    ];
    let velocities = [
        1139.920302151208,
        -1424.379294994111,
        11.03291221937134,
        19.29337464421385,
        0.5735699284790808,
        -19.29337464421385,
        0.3231791658026955,
    ];
    let extrapolated = |value: usize| -> [f64; 7] {
        std::array::from_fn(|k| {
            let (coarse, fine) = (coarse[k][value], fine[k][value]);
            fine + (fine - coarse) / 3.0
        })
    };
    let turned = extrapolated(0);
    let angles = problem_angles(std::array::from_fn(|k| turned[k] + andrews.angles[k]));
    let speeds = problem_angles(extrapolated(1));
    for k in 0..7 {
        let turn = std::f64::consts::TAU;
        let angle = angles[k] + turn * ((positions[k] - angles[k]) / turn).round();
        let position = (angle - positions[k]) / positions[k];
        let speed = (speeds[k] - velocities[k]) / velocities[k];
        assert!(position.abs() < 1e-8 && speed.abs() < 1e-6, "{k}: {position:e}, {speed:e}");
    }
}

/// IFToMM A02: two four-bars of five uniform bars of 1 m and 1 kg in a row, upright, set into motion.
#[test]
fn the_double_four_bar_passes_its_singular_positions() {
    let mut m = Mechanism::new("ground");
    m.set_gravity([0.0, -9.81, 0.0]).unwrap();
    let slender = 1.0 / 12.0;
    let mut feet = vec![];
    let mut bars = vec![];
    let bar = |m: &mut Mechanism, name: &str, center: [f64; 2], upright: bool| {
        let body = m.add_body(name, planar(center)).unwrap();
        let along = if upright { [slender, 0.0] } else { [0.0, slender] };
        let inertia = [along[0], along[1], slender, 0.0, 0.0, 0.0];
        let mass = MassProperties { mass: 1.0, center: planar(center), inertia };
        m.set_mass(body, mass).unwrap();
        // Cranks turn with −1 rad/s, couplers translate with what they carry.
        let (velocity, rotation) = if upright {
            (planar([0.5, 0.0]), [0.0, 0.0, -1.0])
        } else {
            (planar([1.0, 0.0]), [0.0; 3])
        };
        m.set_initial_velocity(body, InitialVelocity { velocity, rotation }).unwrap();
        body
    };
    for k in 0..3 {
        let x = f64::from(k);
        bars.push(bar(&mut m, &format!("crank{k}"), [x, 0.5], true));
        let low = m.add_point(&format!("A{k}"), planar([x, 0.0])).unwrap();
        feet.push(m.add_point(&format!("B{k}"), planar([x, 1.0])).unwrap());
        m.add_joint(&format!("A{k}"), BodyId::GROUND, bars[k as usize], revolute(low)).unwrap();
    }
    for k in 0..2 {
        let coupler = bar(&mut m, &format!("coupler{k}"), [f64::from(k) + 0.5, 1.0], false);
        let k = k as usize;
        m.add_joint(&format!("left{k}"), bars[k], coupler, revolute(feet[k])).unwrap();
        m.add_joint(&format!("right{k}"), bars[k + 1], coupler, revolute(feet[k + 1])).unwrap();
    }
    let system = System::new(m).unwrap();
    assert_eq!(system.freedom().degrees_of_freedom, 1);
    assert_eq!(system.freedom().redundant.len(), 6);
    let mut motion = Dynamics::new(&system, &Start::default(), Integrator::fixed(1e-4)).unwrap();
    assert!(!motion.start().contradicts, "{:?}", motion.start());
    motion.advance_to(10.0).unwrap();
    let [x, y, z] = motion.point_position(bars[0], feet[0]);
    let [vx, vy, _] = motion.point_velocity(bars[0], feet[0]);
    // 3 θ″ = 9.81 · 3.5 sin θ, integrated with a relative tolerance of 1e-13.
    let expected =
        [0.32845811153554066, 0.9445185381804353, 1.4230514701950634, -0.4948688454740032];
    // Velocities are measured with the speed.
    let sizes = [1.0, 1.0, 1.507, 1.507];
    for ((actual, expected), size) in [x, y, vx, vy].into_iter().zip(expected).zip(sizes) {
        assert!((actual - expected).abs() < 1e-6 * size, "{actual} and {expected}");
    }
    assert!(z.abs() < 1e-12, "{z}");
}

/// IFToMM A04: Bricard's mechanism, five square bars of 1 m and six perpendicular hinges.
#[test]
fn bricards_mechanism_moves_with_one_redundant_equation() {
    let mut m = Mechanism::new("ground");
    m.set_gravity([0.0, -9.81, 0.0]).unwrap();
    let corners = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, -1.0, 1.0],
        [0.0, -1.0, 1.0],
        [0.0, 0.0, 1.0],
    ];
    let axes = [1, 2, 0, 1, 2, 0];
    let points: Vec<PointId> =
        (0..6).map(|k| m.add_point(&format!("P{k}"), corners[k]).unwrap()).collect();
    let mut bodies = vec![BodyId::GROUND];
    for k in 0..5 {
        let center: [f64; 3] = std::array::from_fn(|c| 0.5 * (corners[k][c] + corners[k + 1][c]));
        let body = m.add_body(&format!("bar{}", k + 1), center).unwrap();
        let mut inertia = [1.01 / 12.0; 6];
        inertia[3..].fill(0.0);
        let along = (0..3).find(|&c| corners[k][c] != corners[k + 1][c]).unwrap();
        inertia[along] = 0.02 / 12.0;
        m.set_mass(body, MassProperties { mass: 1.0, center, inertia }).unwrap();
        bodies.push(body);
    }
    bodies.push(BodyId::GROUND);
    for k in 0..6 {
        let mut axis = [0.0; 3];
        axis[axes[k]] = 1.0;
        let kind = JointKind::Revolute { at: points[k], axis: Direction::Fixed(axis) };
        m.add_joint(&format!("P{k}"), bodies[k], bodies[k + 1], kind).unwrap();
    }
    let system = System::new(m).unwrap();
    let redundant = &system.freedom().redundant;
    assert_eq!(redundant.len(), 1, "{redundant:?}");
    assert!(redundant[0].label.contains("revolute joint"), "{redundant:?}");
    assert_eq!(system.freedom().degrees_of_freedom, 1);
    let drift = |step: f64| {
        let mut motion =
            Dynamics::new(&system, &Start::default(), Integrator::fixed(step)).unwrap();
        motion.advance_to(10.0).unwrap();
        motion.report().energy_drift
    };
    let (coarse, fine) = (drift(2e-3), drift(1e-3));
    assert!(fine < 1e-3 && coarse / fine > 3.5, "{coarse:e} {fine:e}");
}
