//! Derives the kernels from `constraints/` where the feature `symbolic` is on.

fn main() {
    #[cfg(feature = "symbolic")]
    symbolic::main();
    #[cfg(not(feature = "symbolic"))]
    println!("cargo::rerun-if-changed=build.rs");
}

#[cfg(feature = "symbolic")]
mod symbolic {
    use std::path::Path;
    use std::{env, process};

    use hardpoint_codegen::{Error, generate_folder, render};

    pub fn main() {
        println!("cargo::rerun-if-changed=constraints");
        let out = env::var("OUT_DIR").unwrap_or_default();
        let written = generate_folder(Path::new("constraints"))
            .and_then(|generated| Ok(render::write(&generated.files, Path::new(&out))?));
        if let Err(error) = written {
            report(&error);
        }
    }

    fn report(error: &Error) {
        eprintln!("\n{error}\n");
        process::exit(1);
    }
}
