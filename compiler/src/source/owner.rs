//! Which description a file belongs to.

use std::path::{Path, PathBuf};

use super::load::{MAIN_FILE, load};
use super::loader::or_here;
use super::{Loader, Sources};
use crate::diagnostic::Diagnostics;

/// The `device.toml` in the folder of a file, or in one around it, that includes the file, be it by way of others; none
/// if there is none, or if the file is one itself.
pub fn owner(loader: &dyn Loader, file: &Path) -> Option<PathBuf> {
    let name = loader.canonical(file).ok()?;
    let folders = file.ancestors().skip(1).map(|folder| or_here(folder).join(MAIN_FILE));
    let mains = folders.filter(|main| loader.canonical(main).is_ok_and(|main| main != name));
    // a description is one folder, so no other one has files of it
    let main = mains.into_iter().next()?;
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    load(loader, &main, &[], &mut sources, &mut diagnostics)?;
    let includes = sources.iter().any(|(id, _)| sources.name(id) == Some(&name));
    includes.then_some(main)
}
