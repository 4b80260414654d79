//! An axle whose wheels hang on loads alone, and its answers to small ones.

use hardpoint::model::{Model, Setup, Side, WheelSupport};
use hardpoint::rig::{Axle, Load, LoadPoint, Pose};

/// Loads act at the patches at the loaded radius.
pub const PATCH: bool = true;

const SIDES: [Side; 2] = [Side::Left, Side::Right];

/// How fast a wheel moves by a load.
#[derive(Clone, Copy, Debug)]
pub struct Slopes {
    pub toe: f64,
    pub camber: f64,
    /// The turn about the axis across, the top rearward.
    pub windup: f64,
    /// The turn as a rotation vector.
    pub turn: [f64; 3],
    pub center: [f64; 3],
    /// The point of the body in the patch at the loaded radius.
    pub patch: [f64; 3],
    /// The lowest point of the disc at the radius without load.
    pub lowest: [f64; 3],
}

/// An axle without tyres whose wheels hang on loads alone.
pub struct Hanging {
    axle: Axle,
    loads: [Load; 2],
    base: [Pose<f64>; 2],
    /// From the wheel centres to the patches.
    arms: [[f64; 3]; 2],
}

impl Hanging {
    /// The same state as that of wheels that are held.
    pub fn at(model: &Model, setup: &Setup, held: &[Pose<f64>; 2], rack: f64) -> Self {
        let setup = Setup { support: WheelSupport::Free, ..*setup };
        let mut axle = Axle::with_loads(model, &setup, LoadPoint::WheelCenter).unwrap();
        let loads = [0, 1].map(|side| {
            let mut load = Load::default();
            load.components[2] = held[side].load.unwrap().force;
            load
        });
        axle.set_load(&loads);
        axle.move_to([0.0; 2], rack).unwrap();
        axle.rest().unwrap();
        let base = SIDES.map(|side| axle.pose(side));
        let arms = [0, 1].map(|side| {
            let wheel = held[side].wheel;
            for k in 0..3 {
                let apart = base[side].wheel.center[k] - wheel.center[k];
                assert!(apart.abs() < 1e-9, "{apart:e}");
            }
            let deflection = held[side].tyre.map_or(0.0, |tyre| tyre.deflection);
            let part = 1.0 - deflection / wheel.radius;
            std::array::from_fn(|k| part * (wheel.contact_patch()[k] - wheel.center[k]))
        });
        Self { axle, loads, base, arms }
    }

    /// Slopes of both wheels by a load of which each has the given part.
    pub fn slopes(&mut self, component: usize, at_patch: bool, parts: [f64; 2]) -> [Slopes; 2] {
        let step = if component < 3 { 60.0 } else { 12.0 };
        let mut slope = |step: f64| {
            let [less, more] = [-step, step]
                .map(|size| self.numbers(component, at_patch, parts.map(|p| p * size)));
            [0, 1].map(|side| -> [f64; 14] {
                std::array::from_fn(|k| (more[side][k] - less[side][k]) / (2.0 * step))
            })
        };
        let [whole, half, quarter] = [slope(step), slope(0.5 * step), slope(0.25 * step)];
        [0, 1].map(|side| {
            let numbers: [f64; 14] = std::array::from_fn(|k| {
                // Errors of the second and of the fourth order taken out.
                let finer = (4.0 * quarter[side][k] - half[side][k]) / 3.0;
                let coarser = (4.0 * half[side][k] - whole[side][k]) / 3.0;
                (16.0 * finer - coarser) / 15.0
            });
            let three = |first: usize| std::array::from_fn(|k| numbers[first + k]);
            Slopes {
                toe: numbers[0],
                camber: numbers[1],
                windup: -numbers[3],
                turn: three(2),
                center: three(5),
                patch: three(8),
                lowest: three(11),
            }
        })
    }

    /// Toe, camber, rotation vector from the base, wheel centre, patch of the body, lowest point.
    fn numbers(&mut self, component: usize, at_patch: bool, sizes: [f64; 2]) -> [[f64; 14]; 2] {
        let loads = [0, 1].map(|side| {
            let mut load = self.loads[side];
            load.components[component] += sizes[side];
            if at_patch {
                let mut force = [0.0; 3];
                force[component] = sizes[side];
                let [x, y, z] = self.arms[side];
                let moment = [
                    y * force[2] - z * force[1],
                    z * force[0] - x * force[2],
                    x * force[1] - y * force[0],
                ];
                (0..3).for_each(|k| load.components[3 + k] += moment[k]);
            }
            load
        });
        self.axle.set_load(&loads);
        self.axle.rest().unwrap();
        [0, 1].map(|side| {
            let pose = self.axle.pose(SIDES[side]);
            let (from, to) = (self.base[side].rotation, pose.rotation);
            let r: [[f64; 3]; 3] = std::array::from_fn(|i| {
                std::array::from_fn(|j| (0..3).map(|k| to[i][k] * from[j][k]).sum())
            });
            let axis = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]].map(|x| 0.5 * x);
            let sine = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            let turn = if sine > 0.0 { sine.asin() / sine } else { 1.0 };
            let [sx, sy, sz] = pose.wheel.spin;
            let center = pose.wheel.center;
            let lowest = pose.wheel.contact_patch();
            let arm = self.arms[side];
            let body = |k: usize| center[k] + (0..3).map(|j| r[k][j] * arm[j]).sum::<f64>();
            let mut numbers = [0.0; 14];
            numbers[0] = sx.atan2(pose.side.sign() * sy);
            numbers[1] = -sz.asin();
            for k in 0..3 {
                numbers[2 + k] = turn * axis[k];
                numbers[5 + k] = center[k];
                numbers[8 + k] = body(k);
                numbers[11 + k] = lowest[k];
            }
            numbers
        })
    }
}
