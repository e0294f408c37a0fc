//! The command line as a user meets it: the binary, run in a folder of its own.

#![cfg(test)]

mod arguments;
#[cfg(unix)]
mod at_once;
mod authoring;
mod book;
mod explain;
mod findings;
mod fixes;
mod fmt;
mod foreign;
mod imports;
#[cfg(unix)]
mod interrupted;
mod levels;
#[cfg(feature = "lsp")]
mod lsp;
mod many;
#[cfg(unix)]
mod odd_files;
mod outputs;
#[cfg(unix)]
mod outside;
mod project;
#[cfg(unix)]
mod runs;
mod trouble;
#[cfg(unix)]
mod unix;
mod versions;

use std::fs;
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use tempfile::TempDir;

/// A description that devc has nothing to say about.
const SOUND: &str = r#"
[device]
name   = "Example"
vendor = "Example"

[identity]
vendor-id    = 0x76D
product-code = 3
revision     = 1

[objects.0x2000]
name   = "Speed"
type   = "UINT16"
access = "ro"
"#;

/// A folder to run devc in.
struct Desk {
    folder: TempDir,
}

/// How a run ended and what it said.
struct Run {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Desk {
    /// With the descriptions `devices/<name>/device.toml`.
    fn new(descriptions: &[(&str, &str)]) -> Self {
        let desk = Self { folder: tempfile::tempdir().expect("a temporary folder") };
        for (name, text) in descriptions {
            desk.put(&format!("devices/{name}/device.toml"), text);
        }
        desk
    }

    /// With one sound description, `devices/drive`.
    fn sound() -> Self {
        Self::new(&[("drive", SOUND)])
    }

    fn path(&self, path: &str) -> PathBuf {
        self.folder.path().join(path)
    }

    fn put(&self, path: &str, bytes: impl AsRef<[u8]>) {
        let path = self.path(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("a file");
    }

    fn read(&self, path: &str) -> String {
        fs::read_to_string(self.path(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
    }

    /// The names in a folder, sorted; none if there is no folder.
    fn list(&self, path: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(path)).into_iter().flatten();
        let mut names: Vec<_> = entries
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    fn devc(&self, arguments: &[&str]) -> Run {
        self.finish(&mut self.command(arguments))
    }

    /// devc, to be run in the folder.
    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_devc"));
        command.args(arguments).current_dir(self.folder.path()).env_remove("NO_COLOR");
        command
    }

    /// A script of the shell, with devc as `$1`.
    #[cfg(unix)]
    fn shell(&self, script: &str) -> Run {
        self.finish(Command::new("sh").arg("-c").arg(script).arg("sh").arg(env!("CARGO_BIN_EXE_devc")))
    }

    /// Runs devc in a folder of the folder.
    fn devc_in(&self, folder: &str, arguments: &[&str]) -> Run {
        Self::spawn(self.command(arguments).current_dir(self.path(folder)))
    }

    fn finish(&self, command: &mut Command) -> Run {
        Self::spawn(command.current_dir(self.folder.path()))
    }

    fn spawn(command: &mut Command) -> Run {
        let command = command.env_remove("NO_COLOR").stdin(Stdio::null());
        let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
        Run::of(command.spawn().expect("devc runs"))
    }
}

/// How long a run may take that has next to nothing to do, on a machine that has other things to do.
const PATIENCE: Duration = Duration::from_secs(60);

impl Run {
    /// Waits for a run to end, but not for one that hangs.
    fn of(child: Child) -> Self {
        let (id, (tell, end)) = (child.id(), mpsc::channel());
        thread::spawn(move || tell.send(child.wait_with_output()));
        let Ok(output) = end.recv_timeout(PATIENCE) else {
            let _ = Command::new("kill").args(["-9", &id.to_string()]).status();
            panic!("devc does not end");
        };
        let Output { status, stdout, stderr } = output.expect("devc runs");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("devc writes UTF-8");
        Self { code: status.code(), out: text(stdout), err: text(stderr) }
    }

    /// Asserts the exit code and that what was said has all these words; gives back what was said.
    #[track_caller]
    fn ends(&self, code: i32, words: &[&str]) -> &Self {
        let said = format!("{}{}", self.out, self.err);
        assert_eq!(self.code, Some(code), "{said}");
        for word in words {
            assert!(said.contains(word), "`{word}` is not in:\n{said}");
        }
        self
    }
}
