//! Trade-offs between targets, and spread under tolerances.

use hardpoint::design::request::Request;
use hardpoint::design::synthesis::{Synthesis, Verdict, synthesize};
use hardpoint::model::{Model, Setup};

fn seek(request: &str) -> Synthesis {
    let path = format!("{}/models/double-wishbone.toml", env!("CARGO_MANIFEST_DIR"));
    let model = Model::load(path).unwrap();
    let request = Request::parse("targets.toml", request, &model)
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render()));
    synthesize(&request, &model, &Setup::default()).unwrap()
}

const VARIABLES: &str = "
[[variables]]
points = [\"uca_front\", \"uca_rear\", \"tierod_inner\"]
coordinates = [\"z\"]
range = 15.0
";

/// The designs of a trade-off are no worse in one target than those before, and as much better in the other as the
/// limit between them says; none of them is beaten by a neighbour.
#[test]
fn a_trade_off_goes_from_the_best_for_one_target_to_the_best_for_the_other() {
    let request = format!(
        "format = 1
[[targets]]
name = \"camber\"
factor = \"bump_camber\"
value = -40.0

[[targets]]
name = \"roll_center\"
factor = \"rc_height\"
value = 60.0

[search]
starts = 1

[pareto]
targets = [\"camber\", \"roll_center\"]
points = 6
{VARIABLES}"
    );
    let found = seek(&request);
    let offs: Vec<[f64; 2]> = found.trade_off.iter().map(|design| design.off).collect();
    assert_eq!(offs.len(), 6, "{offs:?}");
    let [first, last] = [offs[0], offs[5]];
    assert!(last[0] < first[0] && last[1] > first[1], "{offs:?}");
    let step = (last[1] - first[1]) / 5.0;
    for (k, pair) in offs.windows(2).enumerate() {
        let [a, b] = [pair[0], pair[1]];
        assert!(b[0] < a[0] + 1e-6 && b[1] > a[1] - 1e-6, "{offs:?}");
        let limit = first[1] + step * (k + 1) as f64;
        assert!((b[1] - limit).abs() < 1e-5 * last[1], "{} for {limit} in {offs:?}", b[1]);
    }
    // What both targets together lead to lies on neither side of the curve of designs.
    let off =
        |value: Option<f64>, wanted: f64, tolerance: f64| (value.unwrap() - wanted) / tolerance;
    let camber = off(found.after[0][0], (-40.0_f64).to_radians(), 0.1_f64.to_radians()).abs();
    let center = off(found.after[1][0], 0.06, 1e-4).abs();
    assert!(!offs.iter().any(|[a, b]| *a < camber - 1e-4 && *b < center - 1e-4), "{offs:?}");
}

/// A factor is held where it is, and the way it is held makes it less sensitive; random designs spread as the first
/// order says.
#[test]
fn spread_under_tolerances_falls_and_is_what_random_designs_have() {
    let request = "format = 1
[[targets]]
name = \"steer\"
factor = \"bump_steer\"
value = 0.0

[[targets]]
factor = \"toe\"
travel = [-40.0, 40.0]
points = 3
hold = true
weight = 0.01

[search]
starts = 1

[tolerances]
points = 0.3
robust = [\"steer\"]
weight = 3.0
samples = 2000

[[variables]]
points = [\"tierod_inner\", \"tierod_outer\"]
coordinates = [\"y\", \"z\"]
range = 20.0
";
    let found = seek(request);
    let [spread] = found.spread[..] else { panic!("{:?}", found.spread) };
    assert!(spread.after < 0.999 * spread.before, "{spread:?}");
    let sampled = spread.sampled.unwrap();
    // The deviation of a deviation from 2000 samples is 1.6 %.
    assert!((sampled / spread.after - 1.0).abs() < 0.06, "{spread:?}");
    assert!(
        matches!(found.verdict, Verdict::Met | Verdict::Compromise { .. }),
        "{:?}",
        found.verdict
    );
    // Without any weight on its spread the factor spreads more.
    let without = seek(&request.replace("weight = 3.0", "weight = 1e-6"));
    assert!(spread.after < without.spread[0].after, "{spread:?} {:?}", without.spread);
}
