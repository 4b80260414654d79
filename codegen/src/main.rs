fn main() {
    let g = hardpoint_codegen::generate_folder(std::path::Path::new("constraints")).unwrap_or_else(
        |e| {
            eprintln!("{e}");
            std::process::exit(1)
        },
    );
    hardpoint_codegen::render::write(&g.files, std::path::Path::new("kernels")).unwrap();
    for k in &g.kernels {
        println!(
            "{} {:?}",
            k.relation.name,
            k.programs
                .iter()
                .map(|p| p.operations().total())
                .collect::<Vec<_>>()
        );
    }
}
