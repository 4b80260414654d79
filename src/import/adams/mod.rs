//! Files of Adams/Car: subsystems (`.sub`), assemblies (`.asy`) that name them, and property files.

mod assembly;
mod files;
mod forces;
mod orbit;
mod subsystem;
mod template;

use super::options::Options;
use super::{ImportError, Imported, Source};
use orbit::Orbit;
pub(crate) use template::{adams_name, of_architecture};

pub(super) fn import(source: Source, options: &Options) -> Result<Imported, ImportError> {
    if source.text.trim_start().starts_with('<') {
        return Err(source.fault(
            "this file is XML",
            "save it as TeimOrbit, the text format of Adams/Car, with [MDI_HEADER] at its top",
        ));
    }
    let orbit = Orbit::parse(source)?;
    let kind = orbit.block("MDI_HEADER").and_then(|header| header.text("FILE_TYPE"));
    let kind = kind.map(str::to_ascii_lowercase);
    match kind.as_deref() {
        Some("sub") => subsystem::import(source, &orbit, options),
        Some("asy") => assembly::import(source, &orbit, options),
        Some(kind @ ("bus" | "spr" | "dpr" | "bum" | "reb" | "tir")) => Err(source.fault(
            format!("a property file (`{kind}`) alone is no suspension"),
            "import the subsystem (.sub) that names it: the curves come with it",
        )),
        Some(other) => Err(source.fault(
            format!("a file of type `{other}` holds no suspension"),
            "import the subsystem of the suspension (.sub), or an assembly (.asy) that names it",
        )),
        None => Err(source.fault(
            "the file has no [MDI_HEADER] with FILE_TYPE",
            "check that it is a file of Adams/Car in the text format TeimOrbit",
        )),
    }
}
