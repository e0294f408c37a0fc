//! The modules of a crate and what each looks to.

use std::collections::BTreeMap;

use crate::code::Code;
use crate::paths::written;

/// The names from the root to a module.
pub(crate) type Name = Vec<String>;

/// The modules of a crate by name.
pub(crate) type Modules = BTreeMap<Name, Module>;

/// One file.
#[derive(Debug)]
pub(crate) struct Module {
    pub(crate) file: String,
    /// The modules of the same crate that it looks to, and in which line.
    pub(crate) looks: Vec<(Name, usize)>,
}

/// A file with the paths in it, from the root of the crate, that it exports and that it uses.
struct Paths {
    file: String,
    exported: BTreeMap<String, Name>,
    used: Vec<(Name, usize)>,
}

/// The modules that the files of a crate are.
pub(crate) fn read(files: &[Code]) -> Modules {
    let files = files.iter().filter(|code| !code.is_test() && !code.path.ends_with("/main.rs"));
    let files: BTreeMap<Name, &Code> = files.map(|code| (name(&code.path), code)).collect();
    let paths: BTreeMap<Name, Paths> = files
        .iter()
        .map(|(name, code)| (name.clone(), paths(name, code, |name| files.contains_key(name))))
        .collect();
    let modules = paths.iter().map(|(name, module)| {
        let looks = module.used.iter().filter_map(|(path, line)| Some((target(&paths, path)?, *line)));
        let looks = looks.filter(|(target, _)| target != name).collect();
        (name.clone(), Module { file: module.file.clone(), looks })
    });
    modules.collect()
}

/// The module that a file of a crate is.
fn name(path: &str) -> Name {
    let (_, inside) = path.split_once("src/").expect("in the sources of a crate");
    let mut parts: Name = inside.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
    if parts.last().is_some_and(|last| ["mod", "lib"].contains(&last.as_str())) {
        parts.pop();
    }
    parts
}

fn paths(name: &Name, code: &Code, is_module: impl Fn(&Name) -> bool) -> Paths {
    let mut paths = Paths { file: code.path.clone(), exported: BTreeMap::new(), used: Vec::new() };
    for path in written(code) {
        let Some(whole) = from_root(name, &path.parts, &is_module) else { continue };
        if path.exported {
            paths.exported.insert(path.name.to_owned(), whole);
        } else {
            paths.used.push((whole, code.line(path.offset)));
        }
    }
    paths
}

/// A path from the root of the crate, if it leads into the crate.
fn from_root(module: &Name, parts: &[&str], is_module: impl Fn(&Name) -> bool) -> Option<Name> {
    let up = parts.iter().take_while(|part| **part == "super").count();
    let (base, rest) = match parts {
        ["crate", rest @ ..] => (&[][..], rest),
        ["self", rest @ ..] => (module.as_slice(), rest),
        _ => (module.get(..module.len().checked_sub(up)?)?, parts.get(up..)?),
    };
    let whole: Name = base.iter().cloned().chain(rest.iter().map(|part| (*part).to_owned())).collect();
    let is_inside = up > 0 || ["crate", "self"].contains(parts.first()?);
    (is_inside || is_module(&whole[..=base.len()].to_vec())).then_some(whole)
}

/// The module in which stands what a path leads to, behind what others export.
fn target(modules: &BTreeMap<Name, Paths>, path: &[String]) -> Option<Name> {
    let length = (0..=path.len()).rev().find(|length| modules.contains_key(&path[..*length]))?;
    let (name, rest) = path.split_at(length);
    let exported = rest.split_first().and_then(|(first, rest)| {
        let whole = modules[name].exported.get(first)?;
        Some(whole.iter().chain(rest).cloned().collect::<Name>())
    });
    match exported {
        Some(whole) if whole != path => target(modules, &whole),
        _ => Some(name.to_vec()),
    }
}
