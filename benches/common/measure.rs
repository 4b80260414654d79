//! How long things are measured, and what is a ratio.

use std::env;
use std::time::{Duration, Instant};

use criterion::Criterion;

/// A way to do something, with its name.
pub type Way<'a> = (&'static str, Box<dyn FnMut() + 'a>);

/// How long a way runs before its neighbour gets its turn.
const BURST: Duration = Duration::from_micros(500);
/// How often each way gets its turn. An odd number, so that the median is one of them.
const ROUNDS: usize = 201;

/// Criterion with times that suit several dozen benchmarks.
pub fn criterion() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(500))
        .sample_size(30)
        .configure_from_args()
}

/// Measures ways to the same end in one group and prints their times as
/// multiples of that of the first.
pub fn compare(criterion: &mut Criterion, name: &str, mut ways: Vec<Way<'_>>) {
    let mut group = criterion.benchmark_group(name);
    for (way, work) in &mut ways {
        group.bench_function(*way, |bencher| bencher.iter(&mut *work));
    }
    group.finish();
    // `cargo test --benches` only tries whether everything runs.
    if env::args().any(|argument| argument == "--bench") {
        println!("\n{name}: time as a multiple of the first, and its middle half");
        let ratios = ratios(&mut ways);
        for ((way, _), [low, median, high]) in ways.iter().zip(ratios) {
            println!("{median:9.2}  ({low:.2} … {high:.2})  {way}");
        }
        println!();
    }
}

/// Quartiles of each way's time divided by that of the first way.
///
/// Criterion measures one way after the other. On a machine that others use the
/// speed changes meanwhile, and with it the ratio of two medians. Here the
/// ways take turns of half a millisecond, and only turns of the same round
/// are divided.
fn ratios(ways: &mut [Way<'_>]) -> Vec<[f64; 3]> {
    let repetitions: Vec<u32> = ways.iter_mut().map(|(_, work)| repetitions(work)).collect();
    let mut ratios = vec![vec![]; ways.len()];
    for _ in 0..ROUNDS {
        let mut first = None;
        for (((_, work), &repetitions), ratios) in
            ways.iter_mut().zip(&repetitions).zip(&mut ratios)
        {
            let time = time(work, repetitions) / f64::from(repetitions);
            ratios.push(time / *first.get_or_insert(time));
        }
    }
    ratios
        .into_iter()
        .map(|mut ratios| {
            ratios.sort_by(f64::total_cmp);
            [ROUNDS / 4, ROUNDS / 2, ROUNDS - 1 - ROUNDS / 4].map(|rank| ratios[rank])
        })
        .collect()
}

/// How often a way fits into a burst.
fn repetitions(work: &mut dyn FnMut()) -> u32 {
    let mut repetitions = 1;
    while time(work, repetitions) < BURST.as_secs_f64() {
        repetitions *= 2;
    }
    repetitions
}

/// Seconds for a number of repetitions.
fn time(work: &mut dyn FnMut(), repetitions: u32) -> f64 {
    let start = Instant::now();
    for _ in 0..repetitions {
        work();
    }
    start.elapsed().as_secs_f64()
}
