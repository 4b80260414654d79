//! The command line of the code generator.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, io};

use hardpoint_codegen::program::Program;
use hardpoint_codegen::source::Source;
use hardpoint_codegen::{Error, Generated, energy, generate, generate_folder, kernel, render};

const HELP: &str = "\
Derives kernels from the relations in constraints/.

Usage: hardpoint-codegen COMMAND

Commands:
  list         the operations of every program of every relation
  show NAME    the kernels of one relation, as Rust
  show FILE    the same for a relation file anywhere (ends in .toml)
  write        rewrite the committed kernels in kernels/

Examples:
  cargo run -p hardpoint-codegen -- show spherical
  cargo run -p hardpoint-codegen -- write
";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    // The binary is only run from a checkout, so the folders are those of the repository.
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let constraints = root.join("constraints");
    let done = match arguments.as_slice() {
        ["list"] => generate_folder(&constraints).map(|generated| print!("{}", list(&generated))),
        ["show", name] => show(&constraints, name),
        ["write"] => generate_folder(&constraints)
            .and_then(|generated| Ok(render::write(&generated.files, &root.join("kernels"))?)),
        ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            Ok(())
        }
        _ => {
            eprint!("{HELP}");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn show(constraints: &Path, name: &str) -> Result<(), Error> {
    let path = if name.ends_with(".toml") {
        PathBuf::from(name)
    } else {
        constraints.join(format!("{name}.toml"))
    };
    let text = std::fs::read_to_string(&path).map_err(|error| {
        let hint = "; `list` shows the relations that there are";
        io::Error::new(error.kind(), format!("{}: {error}{hint}", path.display()))
    })?;
    let generated = generate(vec![Source::new(path, text)])?;
    print!("{}{}", generated.files[0].text, list(&generated));
    Ok(())
}

/// The tables of operation counts, as comments that may stand below Rust code.
fn list(generated: &Generated) -> String {
    let relations = generated.kernels.iter();
    let relations = relations.map(|kernel| (&*kernel.relation.heading.name, &kernel.programs[..]));
    let energies = generated.energies.iter();
    let energies = energies.map(|kernel| (&*kernel.energy.heading.name, &kernel.programs[..]));
    table(&kernel::PROGRAMS, relations.collect())
        + table(&energy::PROGRAMS, energies.collect()).as_str()
}

fn table(programs: &[&str], rows: Vec<(&str, &[Program])>) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let mut table = format!("// {:<23}", "add + mul (div, fn)");
    for program in programs {
        table += &format!("{program:>14}");
    }
    table.push('\n');
    for (name, programs) in rows {
        table += &format!("// {name:<23}");
        for program in programs {
            let operations = program.operations();
            let rare = match (operations.divisions, operations.functions) {
                (0, 0) => String::new(),
                (divisions, functions) => format!(" ({divisions}, {functions})"),
            };
            table += &format!("{:>14}", format!("{}{rare}", operations.total()));
        }
        table.push('\n');
    }
    table
}
