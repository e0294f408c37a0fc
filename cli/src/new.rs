//! `devc new`

use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use devc::format::format;
use devc::source::MAIN_FILE;
use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, context};

use super::outcome::{Failure, Outcome};
use super::report::Report;

const TEMPLATE: &str = include_str!("new/device.toml.j2");

/// Begin a description: a small drive that is whole, with all that a person has to change.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct New {
    /// The folder to make, named as the drive is called.
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,

    /// How many axes the drive has.
    #[arg(long, value_name = "NUMBER", default_value = "1", value_parser = clap::value_parser!(u8).range(1..=8))]
    axes: u8,

    /// The modes of operation, the main one first.
    #[arg(long, value_name = "MODE", value_delimiter = ',', default_value = "csp")]
    mode: Vec<Mode>,
}

const EXAMPLES: &str = "\
Examples:
  devc new devices/mydrive                        one axis, cyclic synchronous position
  devc new devices/mydrive --axes 2 --mode csp,csv,hm";

/// A mode of operation of CiA 402.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Mode {
    /// Profile position.
    Pp,
    /// Profile velocity.
    Pv,
    /// Profile torque.
    Tq,
    /// Homing.
    Hm,
    /// Cyclic synchronous position.
    Csp,
    /// Cyclic synchronous velocity.
    Csv,
    /// Cyclic synchronous torque.
    Cst,
}

/// What a mode needs, CiA 402 part 2.
struct Needs {
    code: i8,
    objects: &'static [&'static str],
    outputs: &'static [&'static str],
    inputs: &'static [&'static str],
}

impl Mode {
    fn needs(self) -> Needs {
        let position = &["target-position"];
        let velocity = &["target-velocity"];
        let torque = &["target-torque"];
        let needs = |code, objects, outputs, inputs| Needs { code, objects, outputs, inputs };
        match self {
            Self::Pp => needs(1, &["0x607A", "0x6081", "0x6083", "0x6084"], position, &[]),
            Self::Pv => {
                needs(3, &["0x60FF", "0x606C", "0x6083", "0x6084"], velocity, &["velocity-actual-value"])
            }
            Self::Tq => needs(4, &["0x6071", "0x6077", "0x6087"], torque, &["torque-actual-value"]),
            Self::Hm => needs(6, &["0x607C", "0x6098", "0x6099", "0x609A"], &[], &[]),
            Self::Csp => needs(8, &["0x607A"], position, &[]),
            Self::Csv => needs(9, &["0x60FF", "0x606C"], velocity, &["velocity-actual-value"]),
            Self::Cst => needs(10, &["0x6071", "0x6077"], torque, &["torque-actual-value"]),
        }
    }
}

impl New {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let name = self.name()?;
        let text = self
            .description(name)
            .map_err(|error| Failure::new(format!("the template is broken: {error:#}")))?;
        fs::create_dir_all(&self.folder).map_err(|error| Failure::at("make", &self.folder, &error))?;
        let text = format(MAIN_FILE, &text).unwrap_or(text);
        write(&self.folder.join(MAIN_FILE), &text)?;
        let folder = self.folder.display();
        report
            .line(&format!("{folder}/{MAIN_FILE} is a whole drive; `devc build {folder}` makes its outputs"));
        Ok(Outcome::Clean)
    }

    /// What the drive is called: the name of the folder, which the outputs are named after.
    fn name(&self) -> Result<&str, Failure> {
        let name = self.folder.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
        match !name.is_empty() && name.chars().all(is_plain) {
            true => Ok(name),
            false => Err(Failure::new(format!("`{}` cannot be the name of a drive", self.folder.display()))
                .help("outputs are named after it: use letters, digits, `-`, `_` and `.`")),
        }
    }

    fn description(&self, name: &str) -> Result<String, minijinja::Error> {
        let mut objects =
            vec!["0x603F", "0x6040", "0x6041", "0x605A", "0x6060", "0x6061", "0x6064", "0x6502"];
        let mut outputs = vec!["controlword", "modes-of-operation"];
        let mut inputs = vec!["statusword", "modes-of-operation-display", "position-actual-value"];
        let mut modes = Vec::new();
        for needs in self.mode.iter().map(|mode| mode.needs()) {
            add(&mut objects, needs.objects);
            add(&mut outputs, needs.outputs);
            add(&mut inputs, needs.inputs);
            add(&mut modes, &[needs.code]);
        }
        objects.sort_unstable();
        let title = if self.axes == 1 {
            "Servo drive".to_owned()
        } else {
            format!("Servo drive for {} axes", self.axes)
        };
        let mut environment = Environment::new();
        environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
        environment.render_str(
            TEMPLATE,
            context! { name, title, axes => self.axes, objects, outputs, inputs, modes },
        )
    }
}

/// Adds what is not there.
fn add<T: PartialEq + Copy>(list: &mut Vec<T>, more: &[T]) {
    for one in more {
        if !list.contains(one) {
            list.push(*one);
        }
    }
}

/// Writes a file that is not there.
fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let file = OpenOptions::new().write(true).create_new(true).open(path);
    let mut file = file.map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => Failure::new(format!("`{}` is there already", path.display()))
            .help("`devc new` begins a description; give it the name of a new folder"),
        _ => Failure::at("write", path, &error),
    })?;
    file.write_all(text.as_bytes()).map_err(|error| Failure::at("write", path, &error))
}
