//! The standard programme of an axle: its time beside the number of states.
#![allow(missing_docs)]

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use hardpoint::factors::{Convention, FACTORS};
use hardpoint::model::{Model, Setup};
use hardpoint::programme::{Ranges, Stage, standard};

/// All events of an axle on bushings, as `hardpoint rig` runs them: without factors, with those that the
/// tangents give, and with the compliance matrix and all factors of every state.
fn programme(criterion: &mut Criterion) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/models/sedan-axle.toml");
    let model = Model::load(path).expect("the model is right");
    let stages = standard(&model, &Ranges::default());
    let states: usize = stages.iter().map(Stage::states).sum();
    let mut group = criterion.benchmark_group("standard programme of models/sedan-axle.toml");
    group.throughput(Throughput::Elements(states as u64)).sample_size(10);
    group.measurement_time(Duration::from_secs(20));
    for (name, kinematic, all) in [
        ("bushed, states and tangents", false, false),
        ("bushed, all factors of all states", false, true),
        ("rigid joints, all factors of all states", true, true),
    ] {
        let setup = Setup { kinematic, ..Setup::default() };
        group.bench_function(name, |bench| {
            bench.iter(|| {
                for stage in &stages {
                    let run = stage.run(&model, &setup, all, |_| {}).expect("the axle moves");
                    let poses = run.sweep.rows.iter().flat_map(|row| &row.poses);
                    for pose in poses.filter(|_| all) {
                        for factor in FACTORS {
                            black_box(factor.value(Convention::Iso, pose));
                        }
                    }
                    black_box(run);
                }
            });
        });
    }
    group.finish();
}

criterion_group!(benches, programme);
criterion_main!(benches);
