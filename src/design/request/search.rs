//! How a design is sought, and what of it: the best, a trade-off, one of little spread.

use toml::Spanned;

use super::read::{Context, positive, whole};
use super::target::Target;
use crate::model::read::Section;
use crate::model::{Report, suggest};

/// How a design is sought.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Search {
    /// From how many designs: the model itself, and points of a Sobol sequence between the bounds.
    pub starts: u32,
    /// Which part of the sequence, and of random numbers.
    pub seed: u32,
    /// The most iterations from each.
    pub iterations: u32,
}

impl Default for Search {
    fn default() -> Self {
        Self { starts: 16, seed: 0, iterations: 100 }
    }
}

/// A trade-off between two targets: the first is met as well as possible while the second is kept at several
/// distances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pareto {
    /// The two targets, by their places among [the targets](super::Request::targets).
    pub targets: [usize; 2],
    /// How many designs.
    pub points: u32,
}

/// Tolerances of hard points, and the factors whose spread under them is to be small.
#[derive(Clone, Debug, PartialEq)]
pub struct Robustness {
    /// Standard deviation (m) of each coordinate of each point, in the order of the model's points: a third of
    /// the tolerance that the request gives.
    pub deviations: Vec<f64>,
    /// Targets whose factors are to spread little, by their places among the targets.
    pub targets: Vec<usize>,
    /// How much their spread, divided by the tolerance of the target, counts against other targets.
    pub weight: f64,
    /// Random designs with which the spread is checked.
    pub samples: u32,
}

/// Tolerances are this many standard deviations.
const SIGMAS: f64 = 3.0;

pub(super) fn search(root: &mut Section, report: &mut Report) -> Search {
    let default = Search::default();
    let help = "write a section `[search]` with `starts = 16`";
    let Some(mut section) = root.optional_section("search", help, report) else { return default };
    let mut number = |key, limits, default| {
        whole(&mut section, key, limits, report).map_or(default, Spanned::into_inner)
    };
    let search = Search {
        starts: number("starts", [1, 100_000], default.starts),
        seed: number("seed", [0, 1_000_000], default.seed),
        iterations: number("iterations", [1, 100_000], default.iterations),
    };
    section.finish(report);
    search
}

pub(super) fn pareto(
    root: &mut Section,
    (targets, known): (&[Target], bool),
    report: &mut Report,
) -> Option<Pareto> {
    let help = "write a section `[pareto]` with `targets = [\"…\", \"…\"]` and `points = 9`";
    let mut section = root.optional_section("pareto", help, report)?;
    let help = "name the two targets: `targets = [\"bump_steer\", \"rc_height\"]`";
    let names = section.required::<[Spanned<String>; 2]>("targets", help, report);
    let points = whole(&mut section, "points", [2, 1000], report);
    section.finish(report);
    let names = names?;
    let found = names.get_ref().each_ref().map(|name| {
        let index = named(name, targets, known, report)?;
        if targets[index].hard {
            let message = format!("`{}` is a constraint, which is always met", name.get_ref());
            report
                .mistake(&name.span(), message, "hard")
                .also(&targets[index].place.0, "this target")
                .help("write `hard = false` there");
            return None;
        }
        Some(index)
    });
    let [Some(first), Some(second)] = found else { return None };
    if first == second {
        report.mistake(&names.span(), "a trade-off needs two targets", "the same twice").help(help);
        return None;
    }
    let points = points.map_or(9, Spanned::into_inner);
    Some(Pareto { targets: [first, second], points })
}

pub(super) fn robustness(
    root: &mut Section,
    context: &Context,
    (targets, known): (&[Target], bool),
    report: &mut Report,
) -> Option<Robustness> {
    let help = "write a section `[tolerances]` with `points = 0.5` and `robust = [\"…\"]`";
    let mut section = root.optional_section("tolerances", help, report)?;
    let all = context.length(&mut section, "points", report);
    let count = context.model.points().len();
    let mut deviations = vec![all.unwrap_or_default() / SIGMAS; count];
    let help = "write the tolerances of single points: `each = { wheel_center = 0.1 }`";
    if let Some(each) = section.optional_section("each", help, report) {
        each.not_empty(help, report);
        for (name, value) in each.entries() {
            let what = format!("the tolerance of `{}`", name.get_ref());
            let read = <f64 as crate::model::read::FromToml>::read(value, &what, report);
            let (Some(point), Some(read)) = (context.point(&name, report), read) else { continue };
            if read < 0.0 {
                report
                    .mistake(&value.span(), format!("{what} is below zero"), "negative")
                    .help("write how far it may be off to both sides, or 0.0");
            }
            let length = Spanned::new(value.span(), read);
            deviations[point] = context.near(&length, &what, report).unwrap_or_default() / SIGMAS;
        }
    }
    if all.is_none() && !section.has("points") && !section.has("each") {
        report
            .mistake(&section.span(), "[tolerances] has no tolerance", "in this section")
            .help("write how far coordinates may be off, to both sides: `points = 0.5`");
    }
    let help = "name the targets whose factors are to spread little: `robust = [\"bump_steer\"]`";
    let names = section.required::<Vec<Spanned<String>>>("robust", help, report);
    if let Some(names) = names.as_ref().filter(|names| names.get_ref().is_empty()) {
        report.mistake(&names.span(), "no target is named", "empty").help(help);
    }
    let weight = positive(&mut section, "weight", report).map_or(1.0, Spanned::into_inner);
    let samples = whole(&mut section, "samples", [10, 1_000_000], report);
    section.finish(report);
    let names = names?;
    let named =
        names.get_ref().iter().filter_map(|name| named(name, targets, known, report)).collect();
    let samples = samples.map_or(1000, Spanned::into_inner);
    Some(Robustness { deviations, targets: named, weight, samples })
}

/// The target of a name.
fn named(
    name: &Spanned<String>,
    targets: &[Target],
    known: bool,
    report: &mut Report,
) -> Option<usize> {
    let word = name.get_ref();
    let found = targets.iter().position(|target| target.name == *word);
    if found.is_none() && known {
        let known: Vec<&str> = targets.iter().map(|target| target.name.as_str()).collect();
        report
            .mistake(&name.span(), format!("there is no target `{word}`"), "unknown target")
            .help(suggest::choices(word, &known));
    }
    found
}
