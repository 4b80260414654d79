//! An assembly names subsystems; that of one suspension is imported.

use super::orbit::Orbit;
use super::{files, subsystem};
use crate::import::options::Options;
use crate::import::{ImportError, Imported, LeftOut, Source};

/// A subsystem that an assembly names.
struct Member {
    line: usize,
    usage: String,
    /// Its path and text, or why they are not there.
    file: Result<(String, String), String>,
    major: String,
    minor: String,
}

pub(super) fn import(
    source: Source,
    orbit: &Orbit,
    options: &Options,
) -> Result<Imported, ImportError> {
    let members = members(source, orbit, options)?;
    let is_suspension = |member: &&Member| member.major.eq_ignore_ascii_case("suspension");
    let suspensions: Vec<&Member> = members.iter().filter(is_suspension).collect();
    let wanted = |member: &&&Member| match options.axle {
        Some(axle) => member.minor.eq_ignore_ascii_case(axle.name()),
        None => true,
    };
    let chosen: Vec<&&Member> = suspensions.iter().filter(wanted).collect();
    let missing =
        || members.iter().find_map(|member| Some((member.line, member.file.as_ref().err()?)));
    let chosen = match (&chosen[..], options.axle) {
        ([only], _) => **only,
        ([], _) => {
            if let Some((line, why)) = missing() {
                return Err(source.mistake(
                    line,
                    why.clone(),
                    "name its database with --database NAME=FOLDER",
                ));
            }
            return Err(
                source.fault("the assembly names no such suspension", "look for [SUBSYSTEM] in it")
            );
        }
        (_, None) => {
            let usages: Vec<&str> = chosen.iter().map(|member| member.usage.as_str()).collect();
            let help = format!(
                "choose with --axle front or --axle rear, or import one: {}",
                usages.join(", ")
            );
            return Err(source.fault("the assembly names more than one suspension", help));
        }
        (_, Some(axle)) => {
            let what = format!("the assembly names more than one {} suspension", axle.name());
            return Err(source.fault(what, "import one of its subsystems"));
        }
    };
    let (path, text) = match &chosen.file {
        Ok(file) => file,
        Err(why) => {
            return Err(source.mistake(
                chosen.line,
                why.clone(),
                "name its database with --database NAME=FOLDER",
            ));
        }
    };
    let inner = Source { name: path, text };
    let mut imported = subsystem::import(inner, &Orbit::parse(inner)?, options)?;
    // The lines of the subsystem are those of another file than the assembly.
    for item in &mut imported.left_out {
        item.what = format!("{} of `{}`", item.what, inner.file_name());
    }
    let others = members.iter().filter(|member| member.line != chosen.line).map(|member| LeftOut {
        line: member.line,
        what: format!("the subsystem `{}`", member.usage),
        why: match &member.file {
            Ok(_) => format!("its major role is `{}`; a model is one suspension", member.major),
            Err(why) => why.clone(),
        },
    });
    imported.left_out.extend(others);
    Ok(imported)
}

/// No vehicle has more subsystems; each is a file.
const MOST_SUBSYSTEMS: usize = 50;

fn members(source: Source, orbit: &Orbit, options: &Options) -> Result<Vec<Member>, ImportError> {
    let blocks = orbit.blocks.iter().filter(|block| block.name == "SUBSYSTEM");
    if let Some(block) = blocks.clone().nth(MOST_SUBSYSTEMS) {
        let what = format!("the assembly names more than {MOST_SUBSYSTEMS} subsystems");
        return Err(source.mistake(block.line, what, "check that it is the right file"));
    }
    let member = |block: &super::orbit::Block| {
        let usage = block.text("USAGE")?.to_owned();
        let file = files::named(&usage, source.name, options);
        let roles = file.as_ref().ok().and_then(|(path, text)| {
            let orbit = Orbit::parse(Source { name: path, text }).ok()?;
            let header = orbit.block("SUBSYSTEM_HEADER")?;
            let role = |key| header.text(key).unwrap_or_default().to_owned();
            Some((role("MAJOR_ROLE"), role("MINOR_ROLE")))
        });
        let (major, minor) = roles.unwrap_or_default();
        Some(Member { line: block.line, usage, file, major, minor })
    };
    Ok(blocks.filter_map(member).collect())
}
