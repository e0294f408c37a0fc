//! The program with all ways, at a level of optimisation.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use devc::emit::c::C;
use devc::emit::{Emitter, Options};
use devc::source::Disk;

use crate::code::{self, Code};
use crate::measure::{Fallible, instructions, run};

/// How often each subject runs.
const ROUNDS: u32 = 1_000;

/// The way that does nothing, which shows what the call costs.
const NOTHING: &str = "nothing";

/// The program as it is built.
pub(crate) struct Program(PathBuf);

/// What was measured, by subject.
pub(crate) struct Measured {
    /// All subjects, in their order.
    subjects: Vec<String>,
    /// Instructions a call, without the call itself.
    pub(crate) instructions: BTreeMap<String, f64>,
    /// Bytes of the functions, without what they call.
    pub(crate) code: BTreeMap<String, f64>,
    /// Bytes of stack of the functions, without what they call and without the place to return to.
    pub(crate) stack: BTreeMap<String, f64>,
}

impl Measured {
    /// The ways, in their order, without the one that does nothing.
    pub(crate) fn ways(&self) -> Vec<&str> {
        let mut ways = Vec::new();
        for (way, _) in self.subjects.iter().filter_map(|subject| subject.rsplit_once(", ")) {
            if way != NOTHING && !ways.contains(&way) {
                ways.push(way);
            }
        }
        ways
    }
}

impl Program {
    /// Builds it beside this benchmark's own folder: at `3` for example, or at `3,lto` as a whole.
    pub(crate) fn built(level: &str) -> Fallible<Self> {
        let own = env::current_exe()?;
        let folder = own.parent().and_then(|folder| folder.parent()?.parent()).ok_or("no target folder")?;
        let target = folder.join("packing");
        let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/packing/Cargo.toml");
        let (level, lto) = level.split_once(',').map_or((level, "false"), |(level, _)| (level, "fat"));
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["build", "--release", "--manifest-path", manifest, "--target-dir"]).arg(&target);
        cargo.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", level).env("CARGO_PROFILE_RELEASE_LTO", lto);
        cargo.env("HEADERS", headers(&target)?);
        run(&mut cargo)?;
        Ok(Self(target.join("release").join("devc-packing").with_extension(env::consts::EXE_EXTENSION)))
    }

    /// What each subject costs.
    pub(crate) fn measured(&self) -> Fallible<Measured> {
        let subjects = self.lines(None)?;
        let instructions = self.instructions(&subjects)?;
        let Code { bytes, stack } = code::of(&self.0, &self.lines(Some("functions"))?)?;
        Ok(Measured { subjects, instructions, code: bytes, stack })
    }

    fn lines(&self, argument: Option<&str>) -> Fallible<Vec<String>> {
        let output = run(Command::new(&self.0).args(argument))?;
        Ok(String::from_utf8(output.stdout)?.lines().map(str::to_owned).collect())
    }

    fn instructions(&self, subjects: &[String]) -> Fallible<BTreeMap<String, f64>> {
        let mut command = Command::new(&self.0);
        let parts = instructions(command.arg(ROUNDS.to_string()), Some("subject_mark"))?;
        // the others are those before, between and after the subjects
        let parts = parts.ok_or("there is no valgrind")?.into_iter().skip(1).step_by(2);
        let each = parts.map(|part| part as f64 / f64::from(ROUNDS));
        let all: BTreeMap<String, f64> = subjects.iter().cloned().zip(each).collect();
        let without_call = all.iter().map(|(subject, cost)| {
            let what = subject.rsplit_once(", ").map_or("", |(_, what)| what);
            let call = all.get(&format!("{NOTHING}, {what}")).copied().unwrap_or(0.0);
            (subject.clone(), cost - call)
        });
        Ok(without_call.collect())
    }
}

/// The folder with the headers in C of the shipped descriptions, made anew.
fn headers(target: &Path) -> Fallible<PathBuf> {
    let folder = target.join("headers");
    fs::create_dir_all(&folder)?;
    for device in ["c887", "pmc-sc6", "s700"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(device);
        let family = devc::compile(&Disk, &path).family.ok_or("a description has errors")?;
        for (name, content) in C.emit(&family, &Options::default()).0 {
            fs::write(folder.join(name), content)?;
        }
    }
    Ok(folder)
}
