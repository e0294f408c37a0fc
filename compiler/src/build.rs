//! For build scripts: the Rust of a description without a derive.
//!
//! ```no_run
//! // build.rs
//! fn main() -> Result<(), devc::build::Failed> {
//!     devc::build::rust("devices/c887", "c887.rs")
//! }
//! ```
//!
//! ```ignore
//! // src/lib.rs
//! include!(concat!(env!("OUT_DIR"), "/c887.rs")); // the module `c887`
//! ```

use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};
use std::{env, fmt, fs, io};

use crate::diagnostic::render::{Style, text};
use crate::diagnostic::{Diagnostic, Level};
pub use crate::emit::rust::Options;
use crate::emit::rust::{LINTS, module, snake};
use crate::lint::Levels;
use crate::source::{Disk, plain};
use crate::text::characters::line;
use crate::{Compilation, Request, compile_with};

/// Writes the Rust of a description to `file` in the folder that Cargo keeps for the build script's outputs, as a
/// module named after the file.
///
/// The path of the description is from the folder of the crate's `Cargo.toml`. Cargo is told to run the script again
/// when the description changes; warnings are passed on to it.
///
/// # Errors
/// The messages, if the description has errors; or that the file cannot be written, or would lie elsewhere.
pub fn rust(description: impl AsRef<Path>, file: impl AsRef<Path>) -> Result<(), Failed> {
    rust_with(description, file, &Options::default())
}

/// The same with a choice of what is in the module: a master does without the dictionary for a firmware.
///
/// ```no_run
/// use devc::build::{Options, rust_with};
///
/// # fn main() -> Result<(), devc::build::Failed> {
/// rust_with("devices/c887", "c887.rs", &Options { dictionary: false, ..Options::default() })
/// # }
/// ```
///
/// # Errors
/// As [`rust`].
pub fn rust_with(
    description: impl AsRef<Path>,
    file: impl AsRef<Path>,
    options: &Options,
) -> Result<(), Failed> {
    let (description, file) = (description.as_ref(), file.as_ref());
    let target = target(env::var_os("OUT_DIR").map(PathBuf::from), file)?;
    let request = Request { levels: Levels::default(), outputs: LINTS.to_vec() };
    let compilation = compile_with(&Disk, description, &request, &mut |_| ());
    tell_cargo(description, &compilation);
    let Some(family) = &compilation.family else {
        return Err(Failed(messages(&compilation, Level::Error).collect::<Vec<_>>().join("\n\n")));
    };
    let name = file.file_stem().map(|stem| stem.to_string_lossy()).unwrap_or_default();
    let code = module(family, &snake(&name), options);
    write_if_changed(&target, &code)
        .map_err(|error| Failed(format!("cannot write `{}`: {error}", target.display())))
}

/// The file in the folder that Cargo keeps for the script: it alone is the script's to write to.
fn target(folder: Option<PathBuf>, file: &Path) -> Result<PathBuf, Failed> {
    let folder = folder.filter(|folder| folder.is_absolute());
    let folder = folder.ok_or_else(|| Failed("there is no `OUT_DIR`: Cargo has to run this".to_owned()))?;
    let mut parts = file.components();
    match (parts.next(), parts.next()) {
        (Some(Component::Normal(name)), None) => Ok(folder.join(name)),
        _ => Err(Failed(format!("`{}` has to be the name of a file in `OUT_DIR`", file.display()))),
    }
}

/// A file that is already right is left alone, so that nothing is built again because of its date.
fn write_if_changed(file: &Path, text: &str) -> io::Result<()> {
    let limit = u64::try_from(text.len()).unwrap_or(u64::MAX).saturating_add(1);
    match plain::read(file, limit) {
        Ok(old) if old == text.as_bytes() => Ok(()),
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        _ => fs::write(file, text),
    }
}

fn messages(compilation: &Compilation, level: Level) -> impl Iterator<Item = String> {
    let wanted = compilation.diagnostics.iter().filter(move |message: &&Diagnostic| message.level == level);
    wanted.map(|message| text(message, &compilation.sources, Style::Plain))
}

/// Cargo listens to what its scripts print, line by line: so a path is one line.
#[expect(clippy::print_stdout, reason = "the protocol of build scripts")]
fn tell_cargo(description: &Path, compilation: &Compilation) {
    for path in std::iter::once(description).chain(compilation.files.iter().map(PathBuf::as_path)) {
        println!("cargo::rerun-if-changed={}", line(&path.to_string_lossy()));
    }
    for warning in messages(compilation, Level::Warning) {
        println!("cargo::warning={}", warning.lines().next().unwrap_or_default());
    }
}

/// Why there is no code.
pub struct Failed(String);

impl fmt::Display for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// As for people: it is what a `main` that returns it prints.
impl fmt::Debug for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{}", self.0)
    }
}

impl std::error::Error for Failed {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_script_writes_to_its_own_folder() {
        let folder = || Some(env::temp_dir());
        assert_eq!(target(folder(), Path::new("c887.rs")).ok(), Some(env::temp_dir().join("c887.rs")));
        for file in ["", "..", "../lib.rs", "/lib.rs", "a/../../lib.rs"] {
            assert!(target(folder(), Path::new(file)).is_err(), "{file}");
        }
        for folder in [None, Some(PathBuf::new()), Some(PathBuf::from("src"))] {
            assert!(target(folder, Path::new("c887.rs")).is_err());
        }
    }
}
