//! The state machine as a picture; as text it is a Mermaid diagram, which GitHub and many other readers draw.

use std::fmt;

use crate::model::{Device, Pattern, State, Transition};

/// The states and what leads from one to another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Machine {
    /// The states.
    pub(in crate::emit) states: Vec<Node>,
    /// The arrows in the order of their first transitions. Transitions between the same states share one.
    pub(in crate::emit) arrows: Vec<Arrow>,
}

/// A state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Node {
    /// What arrows call it.
    pub(in crate::emit) id: String,
    /// Its name.
    pub(in crate::emit) name: String,
    /// The bits of the statusword that show it.
    pub(in crate::emit) bits: Option<String>,
}

/// An arrow.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Arrow {
    /// The id of the state that it begins at, or [`START`].
    pub(in crate::emit) from: String,
    /// The id of the state that it leads to.
    pub(in crate::emit) to: String,
    /// Its transitions.
    pub(in crate::emit) labels: Vec<Label>,
}

/// A transition at an arrow.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Label {
    /// Its number.
    pub(in crate::emit) number: u8,
    /// The commands that set it off.
    pub(in crate::emit) commands: Vec<String>,
    /// The bits of the controlword that ask for it, and what it waits for.
    pub(in crate::emit) facts: Vec<String>,
}

/// What an arrow begins at that nothing comes before.
const START: &str = "[*]";

impl Machine {
    /// The machine of a device, if there is anything to draw.
    pub(super) fn of(device: &Device) -> Option<Self> {
        let arrows = arrows(device);
        let state = |state: &State| Node {
            id: node(&state.id),
            name: plain(&state.name),
            bits: state.pattern.as_ref().map(Pattern::to_string),
        };
        let mut states: Vec<Node> = device.states.iter().map(state).collect();
        if arrows.iter().any(|arrow| arrow.from == ANY) {
            states.push(Node { id: ANY.to_owned(), name: "any state".to_owned(), bits: None });
        }
        (!arrows.is_empty()).then_some(Self { states, arrows })
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("```mermaid\nstateDiagram-v2\n")?;
        for Node { id, name, .. } in &self.states {
            writeln!(f, "    state \"{name}\" as {id}")?;
        }
        for Arrow { from, to, labels } in &self.arrows {
            let labels = labels.iter().map(Label::to_string).collect::<Vec<_>>();
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

fn label(device: &Device, transition: &Transition) -> Label {
    let number = transition.number;
    let commands = || device.commands.iter().filter(|command| command.transitions.contains(&number));
    let names = commands().map(|command| &command.name).chain(&transition.command);
    let patterns = commands().filter_map(|command| command.pattern.as_ref()).chain(&transition.pattern);
    let events = transition.events.iter().map(|event| event.name().to_owned());
    let facts = patterns
        .map(|pattern| format!("controlword {pattern}"))
        .chain(transition.automatic.then(|| "by itself".to_owned()))
        .chain(events)
        .chain(transition.conditions.iter().map(|condition| format!("waits for: {condition}")))
        .chain(transition.causes.iter().cloned());
    Label { number, commands: names.map(|name| plain(name)).collect(), facts: facts.collect() }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.number)?;
        if self.commands.is_empty() { Ok(()) } else { write!(f, " {}", self.commands.join(" or ")) }
    }
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
