//! Where the files lie that subsystems and assemblies name.

use std::path::{Path, PathBuf};

use crate::import::options::{Options, read_text};

/// The path and the text of a file that another names, `mdids://NAME/table/file`, `<NAME>/table/file`
/// or a path;
/// or why it is not there.
pub(super) fn named(
    name: &str,
    beside: &str,
    options: &Options,
) -> Result<(String, String), String> {
    let tried = candidates(name, beside, options);
    for path in &tried {
        if path.is_file() {
            let text = read_text(path)?;
            return Ok((path.display().to_string(), text));
        }
    }
    let tried: Vec<String> = tried.iter().map(|path| format!("`{}`", path.display())).collect();
    Err(format!("`{name}` is not there; looked for {}", tried.join(", ")))
}

/// Where a file may lie: in the folder of its database, in a database around the file that names it,
/// or beside it.
fn candidates(name: &str, beside: &str, options: &Options) -> Vec<PathBuf> {
    let folder = Path::new(beside).parent().unwrap_or(Path::new(""));
    let (database, inside) = split(name);
    let mut paths = vec![];
    if let Some(database) = database {
        let given =
            options.databases.iter().filter(|(known, _)| known.eq_ignore_ascii_case(database));
        paths.extend(given.map(|(_, root)| root.join(inside)));
        // `subsystems.tbl/front.sub` lies beside `springs.tbl`.
        paths.extend(folder.parent().map(|root| root.join(inside)));
    } else {
        paths.push(folder.join(inside));
    }
    let file = inside.rsplit(['/', '\\']).next().unwrap_or(inside);
    paths.push(folder.join(file));
    paths.dedup();
    paths
}

/// The database and the path in it.
fn split(name: &str) -> (Option<&str>, &str) {
    let rest = name.strip_prefix("mdids://");
    let rest = rest.and_then(|rest| rest.split_once('/'));
    let angle = || name.strip_prefix('<').and_then(|rest| rest.split_once(">/"));
    match rest.or_else(angle) {
        Some((database, inside)) => (Some(database), inside),
        None => (None, name),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn databases_have_folders() {
        let options = Options {
            databases: vec![("fsae".to_owned(), PathBuf::from("/data/fsae.cdb"))],
            ..Options::default()
        };
        let paths =
            candidates("mdids://FSAE/springs.tbl/a.spr", "db/subsystems.tbl/x.sub", &options);
        let paths: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
        let expected =
            ["/data/fsae.cdb/springs.tbl/a.spr", "db/springs.tbl/a.spr", "db/subsystems.tbl/a.spr"];
        assert_eq!(paths, expected);
        assert_eq!(split("<x>/a/b.bus"), (Some("x"), "a/b.bus"));
        assert_eq!(split("a.bus"), (None, "a.bus"));
    }
}
