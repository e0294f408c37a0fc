//! Names of outputs.

use devc::text::files;

use super::outcome::Failure;

/// The name of an output, if it can be one wherever it is checked out.
pub(super) fn portable(name: &str) -> Result<&str, Failure> {
    let Some(fault) = files::fault(name) else { return Ok(name) };
    // as in a string, so that what nobody can see is seen
    Err(Failure::new(format!("{name:?} cannot be the name of an output: {fault}"))
        .help("rename the folder of the description: outputs take their name from it"))
}
