//! Motion in time: a quarter of a sedan that settles on its tyre, one second of it.

use criterion::Criterion;
use hardpoint::solve::System;
use hardpoint::solve::dynamics::{Dynamics, Integrator, Start};

#[path = "../tests/common/mod.rs"]
mod common;

fn settling(criterion: &mut Criterion) {
    let (car, _) = common::sedan::quarter_car();
    let released = [car.travel];
    let system = System::new(car.mechanism).expect("the sedan can move");
    let start = Start { released: &released, ..Start::default() };
    let mut group = criterion.benchmark_group("one second of settling");
    let ways =
        [("1000 steps", Integrator::fixed(1e-3)), ("adaptive, 1e-8", Integrator::adaptive(1e-8))];
    for (name, integrator) in ways {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let mut motion = Dynamics::new(&system, &start, integrator).expect("it can begin");
                motion.advance_to(1.0).expect("nothing stops it");
                motion.energy()
            });
        });
    }
    group.finish();
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    settling(&mut criterion);
    criterion.final_summary();
}
