//! `--set`: another value for what the model lets be set.

use clap::Args;
use hardpoint::model::Model;

use crate::failure::Failure;

/// What is set otherwise than in the file.
#[derive(Args)]
pub struct Settings {
    /// Another value for something that the model lets be set, such as toe=0.2 of [static], ride_height=-10 or
    /// tie_rod_length=1.5 of [adjusters], in its units; may be given several times.
    #[arg(long = "set", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
}

impl Settings {
    /// Whether anything is set.
    pub fn given(&self) -> bool {
        !self.set.is_empty()
    }

    /// The model with what is set.
    pub fn apply(&self, mut model: Model) -> Result<Model, Failure> {
        for text in &self.set {
            let wrong = |why: &str| Failure::Usage(format!("--set {text}: {why}"));
            let (name, value) = text
                .split_once('=')
                .ok_or_else(|| wrong("write a name and a number, such as toe=0.2"))?;
            let value = value.trim().parse().map_err(|_| wrong("the value is not a number"))?;
            model.set_static(name.trim(), value).map_err(|why| wrong(&why))?;
        }
        Ok(model)
    }
}
