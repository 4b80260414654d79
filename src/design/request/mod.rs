//! Requests: what a designer wants of a suspension, and what may change for it.
//!
#![doc = include_str!("../../../docs/synthesis.md")]

mod angle;
mod attached;
mod clearance;
mod curve;
mod goal;
mod known;
mod limits;
mod packaging;
mod parameter;
mod read;
mod search;
mod state;
mod target;
mod tie;
mod variable;
mod words;

use std::ops::Range;
use std::path::Path;

use toml::Spanned;

pub use angle::{AngleLimit, Reference};
pub use attached::End;
pub use clearance::{Clearance, Part, Round};
pub use goal::Goal;
pub use limits::Limits;
pub use packaging::PackagingBox;
pub use parameter::{Parameter, Stiffness};
pub use search::{Pareto, Robustness, Search};
pub use target::{State, Target};
pub use tie::{Relation, Tie};
pub use variable::Variable;
pub use words::{short, state_words};

use crate::factors::Need;
use crate::model::{
    self, Mistake, Model, ModelDiagnostics, Report, SourceFile, read_file as read_named,
};
use crate::rig::Event;
use read::Context;

/// A place in the text of a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place(Range<usize>);

/// What a designer wants, in SI units and ISO 8855 axes.
#[derive(Clone, Debug)]
pub struct Request {
    /// The name for reports.
    pub name: Option<String>,
    /// The factors that are wanted, at least one.
    pub targets: Vec<Target>,
    /// What may change, at least one coordinate or parameter, each once.
    pub variables: Vec<Variable>,
    /// What changes together.
    pub ties: Vec<Tie>,
    /// What must not happen.
    pub limits: Limits,
    /// How it is sought.
    pub search: Search,
    /// The trade-off that is asked for.
    pub pareto: Option<Pareto>,
    /// The spread that is asked for.
    pub robustness: Option<Robustness>,
    file: SourceFile,
}

impl Request {
    /// Reads the file of a request for a model, in the units and axes of the model.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the file and of the curves that it names.
    pub fn load(path: impl AsRef<Path>, model: &Model) -> Result<Self, ModelDiagnostics> {
        let (name, text) = read_named(path.as_ref())?;
        Self::parse(&name, &text, model)
    }

    /// Reads a request from the text of a file. `name` is the file name that messages show, and the paths of
    /// curves are relative to it.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the text and of the curves that it names.
    pub fn parse(name: &str, text: &str, model: &Model) -> Result<Self, ModelDiagnostics> {
        const START: &str = "start from the first example of docs/synthesis.md";
        let file = SourceFile::new(name, text);
        let mut report = Report::new(file.clone());
        let request = model::read::read_file_from(START, &file, &mut report, |root, report| {
            let context = Context::new(model);
            let name = root.optional::<String>("name", report).map(Spanned::into_inner);
            let targets = target::read(root, &context, report);
            // A target or variable with a mistake is not missing where others name it.
            let targets_known = report.mistakes.is_empty();
            let locked = variable::locked(root, &context, report);
            // The distance that points may go is how far variables without a range may.
            let mut limits = limits::distances(root, &context, report);
            let variables = variable::read(root, &context, &locked, limits.movement, report);
            let variables_known = report.mistakes.is_empty();
            let ties = tie::read(root, &context, (&variables, variables_known), report);
            limits::read(root, &context, &mut limits, &targets, report);
            let search = search::search(root, report);
            let pareto = search::pareto(root, (&targets, targets_known), report);
            let robustness = search::robustness(root, &context, (&targets, targets_known), report);
            let file = file.clone();
            Some(Self { name, targets, variables, ties, limits, search, pareto, robustness, file })
        });
        model::finish(request, report)
    }

    /// Whether it asks for what only both wheels of an axle have: a factor of the axle, an event of two wheels, or
    /// the wheel of the other side than that of the model.
    pub fn needs_axle(&self, model: &Model) -> bool {
        self.targets.iter().any(|target| {
            let event = matches!(
                target.event,
                Some(
                    Event::Opposite
                        | Event::Single(_)
                        | Event::Roll
                        | Event::LoadOpposed(_)
                        | Event::LoadSingle(..)
                )
            );
            let both =
                target.factor.is_of_axle() || target.factor.needs.contains(&Need::BothWheels);
            let uneven = |state: &State| {
                state.rig.wheels[0] != state.rig.wheels[1] || state.rig.load[0] != state.rig.load[1]
            };
            event || both || target.side != model.side || target.states.iter().any(uneven)
        }) || model.is_axle()
    }

    /// A mistake that shows only later, such as a factor that is not defined at a state: the message, the
    /// words at the underlined place, and what to do.
    pub fn mistake(&self, place: &Place, message: &str, label: &str, help: &str) -> Mistake {
        let mut report = Report::new(self.file.clone());
        report.mistake(&place.0, message, label).help(help).clone()
    }

    /// Mistakes of this request as one error.
    pub fn refuse(&self, mistakes: Vec<Mistake>) -> ModelDiagnostics {
        ModelDiagnostics::new(&self.file.name, mistakes)
    }
}
