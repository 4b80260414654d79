//! Vehicle files of Project Chrono: suspensions and steerings of its templates, in SI units, ISO 8855
//! axes and for the left side.

mod axle_masses;
mod axles;
mod corners;
mod generic;
mod lines;
mod masses;
mod steering;
mod suspension;
mod template;
mod torsion;

use super::json::Json;
use super::options::Options;
use super::{ImportError, Imported, Source};

/// Why a member of a file is not taken over.
const NOT_USED: &str = "a model has no place for it";

pub(super) fn import(
    source: Source,
    root: &Json,
    options: &Options,
) -> Result<Imported, ImportError> {
    let kind = root.text("Type").unwrap_or_default().to_owned();
    let template = root.text("Template").unwrap_or_default().to_owned();
    let name = root.text("Name").unwrap_or(source.file_name()).to_owned();
    match kind.as_str() {
        "Suspension" if template == "GenericWheeledSuspension" => {
            generic::import(source, root, &Title { name, template })
        }
        "Suspension" => suspension::import(source, root, &Title { name, template }, options),
        "Steering" => steering::import(source, root, &Title { name, template }),
        "" => Err(source.fault(
            "the file has no `Type`",
            "hardpoint imports the suspension and steering files of Project Chrono, and models that \
             `hardpoint export --to json` wrote",
        )),
        other => Err(source.fault(
            format!("a file of type `{other}` holds no suspension and no steering"),
            "import the suspension and steering files of the vehicle",
        )),
    }
}

/// What a file says it is.
struct Title {
    name: String,
    template: String,
}
