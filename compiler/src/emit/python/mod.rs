//! Python for scripts and for masters such as `pysoem`: one module a member, the standard library and type annotations.

mod record;
mod text;

use minijinja::context;
use minijinja::value::Serde;

use super::identifier::{Claimed, snake};
use super::program::Program;
use super::{Emitter, Files, Options, template};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::{Device, Family};

/// Makes modules of Python.
#[derive(Debug)]
pub struct Python;

/// What it cannot hold.
const LINTS: &[&Rule] = &[&rules::clashing_identifier::RULE, &rules::empty_name::RULE];

impl Emitter for Python {
    fn name(&self) -> &'static str {
        "python"
    }

    fn summary(&self) -> &'static str {
        "Python: identity, indices, words, states, errors, process data, start-up lists"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".py"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        let mut taken = Claimed::default();
        let modules = family.members.iter().map(|device| {
            let name = importable(&device.id);
            let name = taken.claim(name.clone(), |number| format!("{name}_{number}"));
            (format!("{name}.py"), module(device, &family.id).into_bytes())
        });
        Files(modules.collect())
    }
}

/// The name of a file that can be imported.
fn importable(id: &str) -> String {
    match snake(id) {
        name if name.is_empty() => "device".to_owned(),
        name if name.starts_with(|c: char| c.is_ascii_digit()) => format!("n{name}"),
        name if text::KEYWORDS.contains(&name.as_str()) => format!("{name}_"),
        name => name,
    }
}

fn module(device: &Device, family: &str) -> String {
    let program = Program::of(device, family, text::KEYWORDS);
    let classes = record::Classes::of(&program);
    let context = context! { it => Serde(&program), classes => Serde(classes) };
    template::render("module.py", include_str!("module.py.j2"), text::filters, context)
}
