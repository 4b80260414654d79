//! `hardpoint import`: files of other programs become model files.

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use hardpoint::import::{self, Imported, LeftOut, Options};
use hardpoint::model::{Axes, Axle, LengthUnit};

use crate::failure::Failure;
use crate::output::{Output, SideName};

/// Make a model or mechanism file of a file of another program.
///
/// Reads Adams/Solver datasets (.adm), Adams/Car subsystems and assemblies (.sub, .asy) with their
/// property files, suspension and steering files of Project Chrono (.json), Lotus SHARK (.shk) and Lotus
/// point tables, tables of points (.csv), and models that `hardpoint export --to json` wrote. What is not taken over is listed
/// with its line on stderr, as is what the source does not say and had to be assumed.
#[derive(Args)]
#[command(after_help = "\
Examples:
  hardpoint import Sedan_DoubleWishbone.json -o sedan.toml
  hardpoint import TR_Front_Suspension.sub --database acar_shared=/data/shared_car_database.cdb -o front.toml
  hardpoint import points.csv --architecture double-wishbone --length mm --axes iso8855 -o corner.toml
  hardpoint import pendulum.adm -o pendulum.toml
  hardpoint import car.shk --axle front --wheel-radius 280 -o front.toml")]
pub struct Import {
    /// The file to import.
    file: PathBuf,
    /// Write the model to this file instead of the terminal.
    #[arg(short, long, value_name = "MODEL")]
    output: Option<PathBuf>,
    /// The architecture of the points: a built-in one, or a file of your own ending in .toml.
    #[arg(long, value_name = "NAME")]
    architecture: Option<String>,
    /// The unit of lengths, where the file does not say it.
    #[arg(long, value_enum)]
    length: Option<LengthName>,
    /// The axes, where the file does not say them: iso8855 is x forward, y left, z up; adams is x
    /// rearward, y right,
    /// z up; sae is x forward, y right, z down.
    #[arg(long, value_enum)]
    axes: Option<AxesName>,
    /// The side to take, where the file has two different ones; the side of its points otherwise.
    #[arg(long)]
    side: Option<SideName>,
    /// The axle to take, where the file has two.
    #[arg(long, value_enum)]
    axle: Option<AxleName>,
    /// The rolling radius of the tyre in the unit of the file, where the file has none.
    #[arg(long, value_name = "RADIUS", allow_negative_numbers = true)]
    wheel_radius: Option<f64>,
    /// Leave out of an Adams/Solver dataset what hardpoint does not have, too, although the mechanism is then
    /// another one.
    #[arg(long)]
    lenient: bool,
    /// The folder of an Adams database: `mdids://NAME/…` and `<NAME>/…` lie there. May be repeated.
    #[arg(long, value_name = "NAME=FOLDER", value_parser = database)]
    database: Vec<(String, PathBuf)>,
}

/// A unit of length.
#[derive(Clone, Copy, ValueEnum)]
enum LengthName {
    Mm,
    Cm,
    M,
    In,
}

/// An axis system.
#[derive(Clone, Copy, ValueEnum)]
enum AxesName {
    Iso8855,
    Adams,
    Sae,
}

/// An axle of a vehicle.
#[derive(Clone, Copy, ValueEnum)]
enum AxleName {
    Front,
    Rear,
}

fn database(text: &str) -> Result<(String, PathBuf), String> {
    let parts =
        text.split_once('=').filter(|(name, folder)| !name.is_empty() && !folder.is_empty());
    let (name, folder) = parts.ok_or("write NAME=FOLDER")?;
    if !Path::new(folder).is_dir() {
        return Err(format!("`{folder}` is no folder"));
    }
    Ok((name.to_owned(), PathBuf::from(folder)))
}

impl Import {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let output = Output::beside(&self.file, self.output.as_deref())?;
        let options = self.options()?;
        let name = self.file.display().to_string();
        let text = read(&self.file)?;
        let imported = import::import_with(&name, &text, &options)
            .map_err(|error| Failure::Model(error.diagnostics().clone()))?;
        output.write(|writer| writer.write_all(imported.text.as_bytes()))?;
        tell(&name, &imported);
        Ok(())
    }

    fn options(&self) -> Result<Options, Failure> {
        let wrong = |radius: &f64| !radius.is_finite() || *radius <= 0.0;
        if self.wheel_radius.as_ref().is_some_and(wrong) {
            return Err(Failure::Usage("--wheel-radius must be a positive length".to_owned()));
        }
        Ok(Options {
            architecture: self.architecture.as_deref().map(whole_path).transpose()?,
            length: self.length.map(|length| match length {
                LengthName::Mm => LengthUnit::Millimetre,
                LengthName::Cm => LengthUnit::Centimetre,
                LengthName::M => LengthUnit::Metre,
                LengthName::In => LengthUnit::Inch,
            }),
            axes: self.axes.map(|axes| match axes {
                AxesName::Iso8855 => Axes::Iso8855,
                AxesName::Adams => Axes::Adams,
                AxesName::Sae => Axes::Sae,
            }),
            side: self.side.map(Into::into),
            axle: self.axle.map(|axle| match axle {
                AxleName::Front => Axle::Front,
                AxleName::Rear => Axle::Rear,
            }),
            wheel_radius: self.wheel_radius,
            databases: self.database.clone(),
            lenient: self.lenient,
        })
    }
}

/// An architecture file is written with its whole path, because the model may lie in another folder.
fn whole_path(name: &str) -> Result<String, Failure> {
    if Path::new(name).extension().is_none_or(|ending| ending != "toml") {
        return Ok(name.to_owned());
    }
    let path = fs::canonicalize(name).map_err(|error| {
        Failure::Usage(format!("the architecture `{name}` cannot be read: {error}"))
    })?;
    Ok(path.display().to_string())
}

fn read(path: &Path) -> Result<String, Failure> {
    let wrong = |why: String| Failure::Usage(format!("`{}` cannot be read: {why}", path.display()));
    if path.is_dir() {
        return Err(wrong("it is a folder".to_owned()));
    }
    let bytes = fs::read(path).map_err(|error| wrong(error.to_string()))?;
    Ok(import::text_of(bytes))
}

/// Lists what was left out and what was assumed.
fn tell(name: &str, imported: &Imported) {
    if !imported.left_out.is_empty() {
        eprintln!("left out of {name}:");
        let width =
            imported.left_out.iter().map(|item| item.line.to_string().len()).max().unwrap_or(1);
        for LeftOut { line, what, why } in &imported.left_out {
            eprintln!("  line {line:>width$}: {what}: {why}");
        }
    }
    if !imported.assumed.is_empty() {
        eprintln!("to check, because the file does not say it:");
        for assumed in &imported.assumed {
            eprintln!("  {assumed}");
        }
    }
}
