//! The matrix of a step of motion is the derivative of its residual, by dual numbers.

use hardpoint::assembly::{Blend, Elements, Inertias, Kkt, Motion, Numbering, Terms, design_state};
use hardpoint::energy::Motion as BodyMotion;
use hardpoint::mechanism::{
    Acts, BodyId, Bushing, Contact, Curve, Direction, DriverKind, Expansion, ForceKind, Instance,
    JointKind, Law, LoadFrame, MassProperties, Mechanism, MomentLaw, Reference, RotationMeasure,
    Spline, Triad,
};
use hardpoint::relation::{BODY_COORDINATES, Coordinates, Place};
use hardpoint::scalar::Dual;

const X: Direction = Direction::Fixed([1.0, 0.2, -0.1]);
const Y: Direction = Direction::Fixed([0.3, 1.0, 0.2]);
const Z: Direction = Direction::Fixed([-0.2, 0.1, 1.0]);

/// Three bodies with every kind of joint, driver and force element between them.
fn everything() -> Mechanism {
    let mut m = Mechanism::new("ground");
    m.set_gravity([0.3, -0.2, -9.7]).unwrap();
    let bodies: Vec<BodyId> = (0..3)
        .map(|k| {
            let x = f64::from(k);
            let body = m.add_body(&format!("body{k}"), [x, 0.1, 0.2]).unwrap();
            let center = [x + 0.1, 0.2, 0.05];
            let inertia = [0.3, 0.4, 0.5, 0.05, -0.04, 0.03];
            m.set_mass(body, MassProperties { mass: 2.0 + x, center, inertia }).unwrap();
            body
        })
        .collect();
    let a = m.add_point("a", [0.4, -0.1, 0.3]).unwrap();
    let b = m.add_point("b", [1.3, 0.4, -0.2]).unwrap();
    let [first, second, third] = bodies[..] else { unreachable!() };
    let ground = BodyId::GROUND;
    let joints = [
        JointKind::Revolute { at: a, axis: X },
        JointKind::Universal { at: a, shaft: Y },
        JointKind::Translational { at: b, axis: Z },
        JointKind::Cylindrical { at: b, axis: X },
        JointKind::Link { on_i: a, on_j: b },
        JointKind::Fixed { at: a },
        JointKind::InLine { at: b, axis: Y },
    ];
    let pairs = [(ground, first), (first, second), (second, third), (third, ground)];
    for (k, kind) in joints.into_iter().enumerate() {
        let (i, j) = pairs[k % 4];
        m.add_joint(&format!("joint{k}"), i, j, kind).unwrap();
    }
    let drivers = [
        DriverKind::Displacement { at: a, along: X },
        DriverKind::Rotation { axis: Z },
        DriverKind::Length { on_i: a, on_j: b },
        DriverKind::Height { at: b },
        DriverKind::PatchHeight { center: b, spin: Y, radius: 0.3 },
    ];
    for (k, kind) in drivers.into_iter().enumerate() {
        m.add_driver(&format!("driver{k}"), ground, bodies[k % 3], kind).unwrap();
    }
    let mut number = 0;
    let mut force = |i, j, kind| {
        number += 1;
        m.add_force(&format!("force{number}"), i, j, kind).unwrap();
    };
    let rows = vec![[-0.4, -900.0], [-0.1, -100.0], [0.0, 10.0], [0.2, 350.0], [0.5, 2000.0]];
    let table = Curve::Table(Spline::new("table", rows).unwrap());
    let speeds = vec![[-3.0, -70.0], [-0.5, -30.0], [0.4, 20.0], [2.0, 90.0]];
    let damper = Curve::Table(Spline::new("damper", speeds).unwrap());
    let law = |stiffness: f64, damping: f64| Law {
        viscous: Curve::linear(damping),
        preload: 5.0,
        ..Law::spring(stiffness)
    };
    for law in [law(300.0, 12.0), Law { elastic: table, viscous: damper, ..Law::default() }] {
        let reference = Reference::Design(0.01);
        force(first, third, ForceKind::Line { on_i: a, on_j: b, reference, law });
    }
    force(second, third, ForceKind::Slide { at: a, along: X, law: law(200.0, 8.0) });
    force(first, second, ForceKind::Torsion { axis: Y, law: law(40.0, 3.0) });
    for measure in [RotationMeasure::Angles, RotationMeasure::RotationVector] {
        for moment in [MomentLaw::Energy, MomentLaw::Torque] {
            let bushing = Bushing {
                at: b,
                axes: Triad { x: X, z: Z },
                translation: [law(900.0, 30.0), law(500.0, 20.0), law(700.0, 10.0)],
                rotation: [law(30.0, 2.0), law(20.0, 1.0), law(10.0, 0.5)],
                measure,
                moment,
            };
            force(second, third, ForceKind::Bushing(Box::new(bushing)));
        }
    }
    // So far above the ground that they touch at any random state.
    for contact in [Contact::Center(a), Contact::Patch { center: b, spin: Y }] {
        let law = Law { preload: 0.0, acts: Acts::Below, ..law(2e3, 40.0) };
        force(ground, first, ForceKind::Tyre { contact, free_radius: 0.3, ground: 5.0, law });
    }
    for frame in [LoadFrame::Space, LoadFrame::Body] {
        let direction = [0.3, -0.5, 0.8];
        force(ground, second, ForceKind::PointForce { at: a, frame, direction, size: 70.0 });
        force(ground, third, ForceKind::Moment { frame, direction, size: 9.0 });
    }
    m
}

struct State<S> {
    q: Vec<Coordinates<S>>,
    v: Vec<Coordinates<S>>,
    a: Vec<Coordinates<S>>,
}

/// The generalised forces and Φ, written once more on the kernels of dual numbers.
fn residual(
    expansion: &Expansion,
    laws: &Elements,
    state: &State<Dual>,
    h: &[Dual],
    lambda: &[f64],
) -> (Vec<Dual>, Vec<Dual>) {
    let mut force = vec![Dual::default(); BODY_COORDINATES * (state.q.len() - 1)];
    let mut phi = vec![Dual::default(); expansion.equation_count()];
    let mut add = |instance: &Instance, local: u8, value: Dual| {
        let local = usize::from(local);
        let body = if local < BODY_COORDINATES { instance.i } else { instance.j };
        if body != BodyId::GROUND {
            let unknown = BODY_COORDINATES * (body.index() - 1) + local % BODY_COORDINATES;
            force[unknown] = force[unknown] + value;
        }
    };
    // Φ, Φ_q and the rows that the force works on.
    let evaluate = |instance: &Instance| {
        let shape = instance.kind.shape();
        let place = Place {
            q_i: &state.q[instance.i.index()],
            q_j: &state.q[instance.j.index()],
            h: &h[instance.parameters.clone()],
        };
        let mut phi = vec![Dual::default(); shape.equations];
        let mut phi_q = vec![Dual::default(); shape.jacobian.len()];
        let mut work = vec![Dual::default(); shape.work.len()];
        instance.kind.kernels::<Dual>().jacobian(place, &mut phi, &mut phi_q, &mut work);
        (phi, phi_q, work)
    };
    for instance in expansion.instances() {
        let (value, phi_q, _) = evaluate(instance);
        phi[instance.equations.clone()].copy_from_slice(&value);
        for (&(equation, local), entry) in instance.kind.shape().jacobian.iter().zip(phi_q) {
            let lambda = lambda[instance.equations.start + usize::from(equation)];
            add(instance, local, entry * Dual::new(lambda, 0.0));
        }
    }
    for element in expansion.elements() {
        let instance = &element.instance;
        let shape = instance.kind.shape();
        let (value, phi_q, work) = evaluate(instance);
        let mut rate = vec![Dual::default(); shape.equations];
        for (&(equation, local), entry) in shape.jacobian.iter().zip(&phi_q) {
            let local = usize::from(local);
            let body = if local < BODY_COORDINATES { instance.i } else { instance.j };
            let v = state.v[body.index()][local % BODY_COORDINATES];
            let equation = usize::from(equation);
            rate[equation] = rate[equation] + *entry * v;
        }
        let lambda: Vec<Dual> = (0..shape.equations)
            .map(|k| {
                let law = &laws.laws()[instance.equations.start + k];
                let response = law.at(value[k].value, rate[k].value);
                let derivative =
                    response.by_value * value[k].derivative + response.by_rate * rate[k].derivative;
                Dual::new(response.force, derivative)
            })
            .collect();
        let rows = if shape.has_work() { (shape.work, work) } else { (shape.jacobian, phi_q) };
        for (&(equation, local), entry) in rows.0.iter().zip(rows.1) {
            add(instance, local, entry * lambda[usize::from(equation)]);
        }
    }
    for inertia in expansion.inertias() {
        let body = inertia.body.index();
        let motion = BodyMotion {
            q: &state.q[body],
            v: &state.v[body],
            a: &state.a[body],
            h: &h[inertia.parameters.clone()],
        };
        let mut value = [Dual::default(); BODY_COORDINATES];
        inertia.kind.kernels::<Dual>().force(motion, &mut value);
        for (k, value) in value.into_iter().enumerate() {
            let unknown = BODY_COORDINATES * (body - 1) + k;
            force[unknown] = force[unknown] + value;
        }
    }
    (force, phi)
}

#[test]
fn every_column_is_a_derivative() {
    let mechanism = everything();
    let expansion = Expansion::new(&mechanism);
    let elements = Elements::new(&expansion);
    let numbering = Numbering::new(&expansion, &[]);
    let mut kkt = Kkt::with_forces(
        Terms::new(&expansion),
        elements.clone(),
        Inertias::new(&expansion),
        &numbering,
    );
    let h: Vec<f64> = expansion.parameters(&mechanism.positions());
    let h_dual: Vec<Dual> = h.iter().map(|&h| Dual::new(h, 0.0)).collect();
    let mut random = fastrand::Rng::with_seed(11);
    let mut number = |size: f64| size * (2.0 * random.f64() - 1.0);
    // Weights of a step of 1 ms, of one of 0.1 s, and none in particular.
    for (stiffness, damping, mass) in [(3e-7, 6e-4, 1.1), (3e-3, 6e-2, 1.2), (0.7, 1.3, -0.4)] {
        let blend = Blend { stiffness, damping, mass };
        let mut state = design_state(mechanism.bodies());
        let mut rates = [vec![[0.0; BODY_COORDINATES]; 4], vec![[0.0; BODY_COORDINATES]; 4]];
        for body in 1..state.len() {
            state[body].iter_mut().for_each(|q| *q += number(0.15));
            rates[0][body].iter_mut().for_each(|v| *v = number(2.0));
            rates[1][body].iter_mut().for_each(|a| *a = number(30.0));
        }
        let [velocity, acceleration] = &rates;
        let lambda: Vec<f64> = (0..expansion.equation_count()).map(|_| number(50.0)).collect();
        let motion = Motion { state: &state, velocity, acceleration };
        let mut phi = vec![0.0; lambda.len()];
        kkt.fill_in_motion(motion, &h, &lambda, blend, &mut phi);
        // Every force of the elements acts.
        assert!(kkt.elements().responses().iter().all(|response| response.force != 0.0));
        let unknowns = kkt.unknowns();
        let largest = kkt.values().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let entry = |row, column| kkt.pattern().slot(row, column).map_or(0.0, |k| kkt.values()[k]);
        for column in 0..unknowns {
            let dual = |values: &[Coordinates<f64>], weight: f64| -> Vec<Coordinates<Dual>> {
                let mut dual: Vec<Coordinates<Dual>> =
                    values.iter().map(|body| body.map(|x| Dual::new(x, 0.0))).collect();
                dual[column / BODY_COORDINATES + 1][column % BODY_COORDINATES].derivative = weight;
                dual
            };
            let state = State {
                q: dual(&state, stiffness),
                v: dual(velocity, damping),
                a: dual(acceleration, mass),
            };
            let (force, value) = residual(&expansion, &elements, &state, &h_dual, &lambda);
            for row in 0..unknowns {
                let (actual, expected) = (entry(row, column), force[row].derivative);
                let size = expected.abs().max(1e-3 * largest);
                assert!(
                    (actual - expected).abs() < 1e-11 * size,
                    "({row}, {column}): {actual} and {expected}"
                );
                let (actual, expected) = (kkt.force()[row], force[row].value);
                assert!((actual - expected).abs() < 1e-11 * kkt.magnitude()[row].max(1.0));
            }
            for equation in 0..lambda.len() {
                let expected = value[equation].derivative / stiffness;
                for actual in
                    [entry(unknowns + equation, column), entry(column, unknowns + equation)]
                {
                    assert!((actual - expected).abs() < 1e-11 * expected.abs().max(1.0));
                }
                assert!((phi[equation] - value[equation].value).abs() < 1e-13);
            }
        }
    }
}
