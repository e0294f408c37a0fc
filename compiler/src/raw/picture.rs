//! Pictures that a description names: files beside it, read once its tables are.

use std::path::{Path, PathBuf};

use super::{RawDevice, RawHead, Reading};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::source::{Loader, Location, or_here, outside};

/// The most bytes that a picture can have: four for each point, and a head, are less than half of it.
pub(crate) const MOST: usize = 2_048;

/// Reads the pictures of all members, and notes their files.
pub fn pictures(
    loader: &dyn Loader,
    members: &mut [Reading],
    files: &mut Vec<PathBuf>,
    diagnostics: &mut Diagnostics,
) {
    let Some(folder) = files.first().and_then(|main| main.parent()).map(Path::to_owned) else { return };
    for Reading { printed, corrected } in members {
        for device in [Some(printed), corrected.as_mut()].into_iter().flatten() {
            let Some((head, name, at)) = named(device) else { continue };
            let path = folder.join(&name);
            match read(loader, &folder, &path, &name, at) {
                Ok(bytes) => head.image_bytes = Some(bytes),
                Err(fault) => diagnostics.push(fault),
            }
            if !files.contains(&path) {
                files.push(path);
            }
        }
    }
}

/// The picture of a device, and where it is named.
fn named(device: &mut RawDevice) -> Option<(&mut RawHead, String, Location)> {
    let head = device.head.as_mut()?;
    let (name, at) = (head.image.clone()?, head.origin.value("image"));
    Some((head, name, at))
}

fn read(
    loader: &dyn Loader,
    folder: &Path,
    path: &Path,
    name: &str,
    at: Location,
) -> Result<Vec<u8>, Diagnostic> {
    let missing = || {
        let message = format!("`{name}` does not exist, or cannot be read");
        Diagnostic::new(&faults::MISSING_FILE, message, at, "named here")
            .note("a picture is relative to the folder of the description")
    };
    let folder = loader.canonical(or_here(folder));
    let folder = folder.map_err(|_| missing())?;
    let opened = loader.read(path).map_err(|_| missing())?;
    if !opened.name.starts_with(&folder) {
        return Err(outside(name, at));
    }
    if opened.bytes.len() > MOST {
        let message = format!("`{name}` has more than {MOST} bytes");
        let fault = Diagnostic::new(&faults::EXCEEDED_LIMIT, message, at, "too large for 16 by 14 points");
        return Err(fault.help("save it as a BMP file of that size"));
    }
    Ok(opened.bytes)
}
