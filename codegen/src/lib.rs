//! Turns equations written as text into differentiated, specialised Rust kernels.
//!
//! A relation file states equations Φ(q; h) = 0 between two bodies, or the kinetic
//! energy T(q, q̇; h) of one. The stages of its way to Rust are the modules of this
//! crate, in this order:
//!
//! | stage | module |
//! |---|---|
//! | file → text with positions | [`source`] |
//! | text → TOML tables | [`definition`] |
//! | strings → expressions | [`expression`] |
//! | names, shapes and units checked | [`validate`], `quantity`, [`mod@unit`] |
//! | expressions → scalars over named intermediates | [`lower`], [`algebra`], `polynomial`, [`alphabet`] |
//! | scalars → derivatives | [`differentiate`] |
//! | derivatives → straight-line programs | [`program`], [`translate`], [`kernel`], [`energy`] |
//! | programs → Rust tokens → files | [`emit`], [`emit_relation`], [`emit_energy`], `body`, [`render`] |
//!
//! All of it is pure except [`session`], the one door to the computer algebra
//! system, and the reading and writing of files.

pub mod algebra;
pub mod alphabet;
mod body;
pub mod definition;
pub mod differentiate;
pub mod emit;
pub mod emit_energy;
pub mod emit_relation;
pub mod energy;
pub mod expression;
pub mod kernel;
pub mod lower;
mod polynomial;
pub mod program;
mod quantity;
pub mod render;
pub mod session;
pub mod source;
pub mod translate;
pub mod unit;
pub mod validate;

use std::collections::HashMap;
use std::path::Path;
use std::{fmt, io};

use alphabet::Alphabet;
use energy::EnergyKernel;
use kernel::{Kernel, KernelError};
use lower::Flaw;
use render::File;
use source::{Mistake, Mistakes, Source};
use validate::Checked;

/// Kernels for a set of relation files.
#[derive(Clone, Debug)]
pub struct Generated {
    /// The relations in the order of their names.
    pub kernels: Vec<Kernel>,
    /// The kinetic energies in the order of their names.
    pub energies: Vec<EnergyKernel>,
    /// One file for each relation, then for each energy, then [`render::INDEX`].
    pub files: Vec<File>,
}

/// Why there are no kernels.
#[derive(Debug)]
pub enum Error {
    /// Relation files with mistakes.
    Mistakes(Vec<Mistakes>),
    /// No session with the computer algebra system.
    Session(session::SessionError),
    /// A folder or file that cannot be read or written.
    File(io::Error),
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mistakes(files) => {
                for mistakes in files {
                    write!(formatter, "{mistakes}")?;
                }
                let count: usize = files.iter().map(|file| file.mistakes.len()).sum();
                let (mistakes, files) = (plural(count, "mistake"), plural(files.len(), "file"));
                write!(formatter, "{mistakes} in {files} of relations")
            }
            Self::Session(error) => error.fmt(formatter),
            Self::File(error) => error.fmt(formatter),
        }
    }
}

fn plural(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

impl std::error::Error for Error {}

impl From<io::Error> for Error {
    fn from(error: io::Error) -> Self {
        Self::File(error)
    }
}

impl From<session::SessionError> for Error {
    fn from(error: session::SessionError) -> Self {
        Self::Session(error)
    }
}

/// Generates the kernels of all relation files of a folder.
///
/// # Errors
/// All mistakes in all files, or what the system says.
pub fn generate_folder(folder: &Path) -> Result<Generated, Error> {
    let sources = source::read_folder(folder)
        .map_err(|error| io::Error::new(error.kind(), format!("{}: {error}", folder.display())))?;
    generate(sources)
}

/// Generates the kernels of relation files.
///
/// # Errors
/// All mistakes in all files, or why there is no session.
pub fn generate(mut sources: Vec<Source>) -> Result<Generated, Error> {
    sources.sort_by(|a, b| a.name.cmp(&b.name));
    let mut checked = Vec::new();
    let mut wrong = Vec::new();
    for source in sources {
        match check(&source) {
            Ok(file) => checked.push((source, file)),
            Err(mistakes) => wrong.push(Mistakes { source, mistakes }),
        }
    }
    wrong.extend(one_type_twice(&mut checked));
    // Mistakes that only differentiation finds are told together with the others.
    let (generated, flawed) = session::run(move || derive(checked))?;
    wrong.extend(flawed);
    wrong.sort_by(|a, b| a.source.path.cmp(&b.source.path));
    if wrong.is_empty() { Ok(generated) } else { Err(Error::Mistakes(wrong)) }
}

/// Reads and checks one file, as far as that goes without algebra.
///
/// # Errors
/// All its mistakes.
pub fn check(source: &Source) -> Result<Checked, Vec<Mistake>> {
    match definition::read(source) {
        (Some(definition), mistakes) => validate::check(source, &definition, mistakes),
        (None, mistakes) => Err(mistakes),
    }
}

/// Takes out the files whose type another one has already: `arm_1` and `arm1` are both `Arm1`.
fn one_type_twice(files: &mut Vec<(Source, Checked)>) -> Vec<Mistakes> {
    let mut taken: HashMap<String, String> = HashMap::new();
    let mut wrong = Vec::new();
    files.retain(|(source, checked)| {
        let type_name = emit::type_name(&checked.heading().name);
        let Some(first) = taken.get(&type_name) else {
            taken.insert(type_name, source.name.clone());
            return true;
        };
        let message = format!("`{}` and `{first}` both give the type `{type_name}`", source.name);
        let mistake = Mistake::new(0..0, message, "give one of the two files another name");
        wrong.push(Mistakes { source: source.clone(), mistakes: vec![mistake] });
        false
    });
    wrong
}

fn derive(checked: Vec<(Source, Checked)>) -> (Generated, Vec<Mistakes>) {
    let alphabet = Alphabet::register();
    let mut kernels = Vec::new();
    let mut energies = Vec::new();
    let mut wrong = Vec::new();
    for (source, checked) in checked {
        let done = match &checked {
            Checked::Relation(relation) => {
                Kernel::new(relation, &alphabet).map(|kernel| kernels.push(kernel))
            }
            Checked::Energy(energy) => {
                EnergyKernel::new(energy, &alphabet).map(|kernel| energies.push(kernel))
            }
        };
        if let Err(error) = done {
            wrong.push(Mistakes { source, mistakes: mistakes(&checked, &error) });
        }
    }
    let relation_headings: Vec<_> = kernels.iter().map(|kernel| &kernel.relation.heading).collect();
    let energy_headings: Vec<_> = energies.iter().map(|kernel| &kernel.energy.heading).collect();
    let modules = kernels.iter().map(|kernel| emit_relation::module(kernel, &alphabet));
    let modules =
        modules.chain(energies.iter().map(|kernel| emit_energy::module(kernel, &alphabet)));
    let mut files: Vec<File> = relation_headings
        .iter()
        .chain(&energy_headings)
        .zip(modules)
        .map(|(heading, module)| render::file(&format!("{}.rs", heading.name), module))
        .collect();
    let index = emit::index(&relation_headings, &energy_headings);
    files.push(render::file(render::INDEX, index));
    (Generated { kernels, energies, files }, wrong)
}

fn mistakes(checked: &Checked, error: &KernelError) -> Vec<Mistake> {
    let (stated, work) = match checked {
        Checked::Relation(relation) => {
            (&relation.residual, relation.work.as_ref().unwrap_or(&relation.residual))
        }
        Checked::Energy(energy) => (&energy.energy, &energy.energy),
    };
    let flaws = match error {
        KernelError::Flaws(flaws) => flaws,
        KernelError::Program(error) => {
            return vec![Mistake::new(
                stated.span.clone(),
                error.to_string(),
                "simplify the expression, or name parts of it under [definitions]",
            )];
        }
    };
    let mistake = |flaw: &Flaw| match flaw {
        Flaw::ConstantEquation(row) => Mistake::new(
            stated.row(*row).span.clone(),
            format!("equation {} does not depend on the position of a body", row + 1),
            "no motion can fulfil it; use the coordinates of body i or j",
        ),
        Flaw::ZeroDivisor(span) => Mistake::new(
            span.clone(),
            "the divisor is zero at every position",
            "divide by something that is never zero",
        ),
        Flaw::RootOfConstant(span) => Mistake::new(
            span.clone(),
            "the root of a number that is not positive has no derivative",
            "take the root of something that is always positive",
        ),
        Flaw::AtanRatioOfConstant(span) => Mistake::new(
            span.clone(),
            "`atan_ratio` has no value for -1 and smaller numbers",
            "give it something that is always larger than -1, such as a square",
        ),
        Flaw::AngleOfOrigin(span) => Mistake::new(
            span.clone(),
            "both arguments of `atan2` are zero at every position",
            "the origin has no angle; give it the sine and the cosine of one",
        ),
        Flaw::NoMass => Mistake::new(
            stated.span.clone(),
            "the energy does not depend on the velocity",
            "use velocity_i or omega_i; a potential energy is a relation with a force law",
        ),
        Flaw::NotQuadratic => Mistake::new(
            stated.span.clone(),
            "the energy is not quadratic in the velocity",
            "a kinetic energy is a sum of products of two components of velocity_i and omega_i",
        ),
        Flaw::ConstantWork(row) => Mistake::new(
            work.row(*row).span.clone(),
            format!("row {} of work has no virtual motion", row + 1),
            "write it linear in delta_r_i, delta_theta_i, delta_r_j, delta_theta_j",
        ),
        Flaw::NonlinearWork(row) => Mistake::new(
            work.row(*row).span.clone(),
            format!("row {} of work is not linear in the virtual motion", row + 1),
            "let delta_* stand once in each product",
        ),
    };
    flaws.iter().map(mistake).collect()
}
