//! The state machine as a picture; as text it is a Mermaid diagram, which GitHub and many other readers draw.

use std::fmt;

use crate::model::{Device, Transition};

/// The states and what leads from one to another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Machine {
    /// The states by id and name.
    pub(in crate::emit) states: Vec<(String, String)>,
    /// The arrows in the order of their first transitions. Transitions between the same states share one.
    pub(in crate::emit) arrows: Vec<Arrow>,
}

/// An arrow.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Arrow {
    /// The id of the state that it begins at, or [`START`].
    pub(in crate::emit) from: String,
    /// The id of the state that it leads to.
    pub(in crate::emit) to: String,
    /// The number of each transition, with what sets it off.
    pub(in crate::emit) labels: Vec<String>,
}

/// What an arrow begins at that nothing comes before.
const START: &str = "[*]";

impl Machine {
    /// The machine of a device, if there is anything to draw.
    pub(super) fn of(device: &Device) -> Option<Self> {
        let arrows = arrows(device);
        let mut states: Vec<_> =
            device.states.iter().map(|state| (node(&state.id), plain(&state.name))).collect();
        if arrows.iter().any(|arrow| arrow.from == ANY) {
            states.push((ANY.to_owned(), "any state".to_owned()));
        }
        (!arrows.is_empty()).then_some(Self { states, arrows })
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("```mermaid\nstateDiagram-v2\n")?;
        for (id, name) in &self.states {
            writeln!(f, "    state \"{name}\" as {id}")?;
        }
        for Arrow { from, to, labels } in &self.arrows {
            writeln!(f, "    {from} --> {to}: {}", labels.join("<br>"))?;
        }
        f.write_str("```")
    }
}

fn arrows(device: &Device) -> Vec<Arrow> {
    let mut arrows: Vec<Arrow> = Vec::new();
    for transition in device.transitions.iter().filter(|transition| transition.supported) {
        let (to, label) = (node(&transition.to), label(device, transition));
        for from in starts(transition) {
            match arrows.iter_mut().find(|arrow| (&arrow.from, &arrow.to) == (&from, &to)) {
                Some(arrow) => arrow.labels.push(label.clone()),
                None => arrows.push(Arrow { from, to: to.clone(), labels: vec![label.clone()] }),
            }
        }
    }
    arrows
}

const ANY: &str = "any_state";

fn starts(transition: &Transition) -> Vec<String> {
    match &*transition.from {
        [] if transition.number == 0 => vec![START.into()],
        [] => vec![ANY.into()],
        states => states.iter().map(|id| node(id)).collect(),
    }
}

fn label(device: &Device, transition: &Transition) -> String {
    let number = transition.number;
    let commands = device.commands.iter().filter(|command| command.transitions.contains(&number));
    let names = commands.map(|command| &command.name).chain(&transition.command);
    let names: Vec<String> = names.map(|name| plain(name)).collect();
    if names.is_empty() { number.to_string() } else { format!("{number} {}", names.join(" or ")) }
}

/// An id as Mermaid takes it.
fn node(id: &str) -> String {
    id.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect()
}

/// A name on one line, without what means something to Mermaid.
fn plain(name: &str) -> String {
    let marked = |c: char| c.is_whitespace() || "\":;<>#{}".contains(c);
    name.replace(marked, " ")
}
