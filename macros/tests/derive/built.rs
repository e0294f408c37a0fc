//! The runtime with its derives as cargo has built it for this very test, so that users of it can be compiled without
//! building all that it depends on once more.

use std::collections::BTreeSet;
use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

use serde_json::Value;

/// What rustc has to be told to find the libraries.
pub(crate) static FLAGS: LazyLock<Vec<String>> = LazyLock::new(|| Built::find().flags());

/// Where the libraries are.
#[derive(Debug, Default)]
struct Built {
    runtime: PathBuf,
    folders: BTreeSet<PathBuf>,
}

impl Built {
    /// Asks cargo. What features a package has depends on which others are built with it; these are those of
    /// `cargo test --workspace`, behind which nothing is left to build.
    fn find() -> Self {
        let output = cargo()
            .args(["test", "--workspace", "--test=derive", "--no-run", "--message-format=json"])
            .current_dir(root())
            .stderr(Stdio::inherit())
            .output()
            .expect("cargo runs");
        assert!(output.status.success(), "this test was built before");
        let messages = serde_json::Deserializer::from_slice(&output.stdout).into_iter::<Value>();
        let mut built = Self::default();
        for message in messages.map(|message| message.expect("cargo writes JSON")) {
            let files = message["filenames"].as_array().into_iter().flatten().filter_map(Value::as_str);
            for file in files.map(PathBuf::from) {
                built.folders.extend(file.parent().map(Path::to_owned));
                if message["target"]["name"] == "devc_runtime"
                    && file.extension().is_some_and(|end| end == "rlib")
                {
                    built.runtime = file;
                }
            }
        }
        assert!(built.runtime.exists(), "the runtime is a library");
        built
    }

    fn flags(&self) -> Vec<String> {
        let runtime = ["--extern".to_owned(), format!("devc_runtime={}", self.runtime.display())];
        let folders = self.folders.iter().map(|folder| format!("-Ldependency={}", folder.display()));
        runtime.into_iter().chain(folders).collect()
    }
}

pub(crate) fn cargo() -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["--quiet", "--offline"]);
    cargo
}

/// The folder of the workspace.
pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the package is in the workspace")
}
