//! What is generated: its text, its operation counts, and that it is the same every time.

use std::path::Path;

use hardpoint_codegen::source::{Source, read_folder};
use hardpoint_codegen::{Generated, generate};

fn folder(name: &str) -> Vec<Source> {
    read_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).expect("the folder is there")
}

fn relations() -> Vec<Source> {
    folder("../constraints")
}

fn generated(sources: Vec<Source>) -> Generated {
    generate(sources).unwrap_or_else(|error| panic!("{error}"))
}

/// Additions + multiplications of the programs of every relation and energy.
///
/// A larger number needs a reason; a smaller one is written here and kept.
#[test]
fn operation_counts_are_pinned() {
    let Generated { kernels, energies, .. } = generated(relations());
    let found: Vec<(String, Vec<usize>)> = kernels
        .iter()
        .map(|kernel| {
            let counts = kernel.programs.iter().map(|program| program.operations().total());
            (kernel.relation.heading.name.clone(), counts.collect())
        })
        .collect();
    let pinned = [
        ("bushing_angles", [276, 616, 2735, 4157, 2839]),
        ("bushing_angles_torque", [276, 747, 1141, 752, 2837]),
        ("bushing_rotation_vector", [60, 375, 1729, 333, 748]),
        ("bushing_rotation_vector_torque", [60, 629, 1023, 284, 748]),
        ("bushing_translation", [229, 441, 899, 1539, 1357]),
        ("displacement", [138, 213, 455, 644, 719]),
        ("distance", [97, 163, 682, 637, 700]),
        ("euler_parameters", [8, 12, 13, 0, 4]),
        ("force_in_body", [0, 116, 375, 292, 0]),
        ("moment_in_body", [0, 66, 126, 98, 0]),
        ("moment_in_space", [0, 25, 31, 8, 0]),
        ("orthogonal_1", [87, 135, 246, 386, 510]),
        ("orthogonal_2", [137, 212, 454, 644, 719]),
        ("patch_height", [60, 81, 143, 126, 206]),
        ("point_height", [29, 34, 40, 23, 49]),
        ("position_along", [50, 74, 106, 125, 168]),
        ("rack_and_pinion", [274, 503, 2224, 3640, 1942]),
        ("rotation", [136, 226, 373, 767, 735]),
        ("spherical", [91, 106, 158, 120, 156]),
        ("squared_distance", [98, 148, 372, 580, 524]),
        ("torsion", [134, 251, 847, 1289, 1159]),
    ];
    let pinned: Vec<(String, Vec<usize>)> =
        pinned.iter().map(|(name, counts)| ((*name).to_owned(), counts.to_vec())).collect();
    assert_eq!(found, pinned);
    let found: Vec<(&str, [usize; 3])> = energies
        .iter()
        .map(|kernel| {
            let counts = kernel.programs.each_ref().map(|program| program.operations().total());
            (&*kernel.energy.heading.name, counts)
        })
        .collect();
    assert_eq!(found, [("rigid_body", [125, 460, 2034])]);
}

/// The text of one small relation, and of one that states `work`.
#[test]
fn text_of_small_relations() {
    let mut sources = relations();
    sources.retain(|source| ["euler_parameters", "moment_in_space"].contains(&&*source.name));
    for file in generated(sources).files {
        insta::assert_snapshot!(file.name, file.text);
    }
}

/// A relation gives the same bytes whatever was generated before it.
#[test]
fn text_does_not_depend_on_the_other_relations() {
    let all = generated(relations()).files;
    let mut backwards = relations();
    backwards.reverse();
    let backwards = generated(backwards).files;
    for file in &all[..all.len() - 1] {
        let other = backwards.iter().find(|other| other.name == file.name);
        assert_eq!(other, Some(file));
        let name = file.name.trim_end_matches(".rs");
        let alone = relations().into_iter().filter(|source| source.name == name).collect();
        assert_eq!(&generated(alone).files[0], file);
    }
}
