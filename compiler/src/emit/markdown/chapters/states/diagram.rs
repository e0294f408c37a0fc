//! The state machine as a Mermaid diagram, which GitHub and many other readers draw.

use crate::model::{Device, Transition};

/// The diagram; empty if there is nothing to draw. Transitions between the same states share an arrow.
pub(super) fn diagram(device: &Device) -> String {
    let arrows = arrows(device);
    if arrows.is_empty() {
        return String::new();
    }
    let mut lines: Vec<String> = vec!["stateDiagram-v2".into()];
    lines.extend(
        device
            .states
            .iter()
            .map(|state| format!("    state \"{}\" as {}", plain(&state.name), node(&state.id))),
    );
    if arrows.iter().any(|(from, ..)| from == ANY) {
        lines.push(format!("    state \"any state\" as {ANY}"));
    }
    lines.extend(
        arrows.iter().map(|(from, to, labels)| format!("    {from} --> {to}: {}", labels.join("<br>"))),
    );
    lines.join("\n")
}

/// The arrows in the order of their first transitions: from, to, labels.
fn arrows(device: &Device) -> Vec<(String, String, Vec<String>)> {
    let mut arrows: Vec<(String, String, Vec<String>)> = Vec::new();
    for transition in device.transitions.iter().filter(|transition| transition.supported) {
        let (to, label) = (node(&transition.to), label(device, transition));
        for from in starts(transition) {
            match arrows.iter_mut().find(|(start, end, _)| (start, end) == (&from, &to)) {
                Some((.., labels)) => labels.push(label.clone()),
                None => arrows.push((from, to.clone(), vec![label.clone()])),
            }
        }
    }
    arrows
}

const ANY: &str = "any_state";

fn starts(transition: &Transition) -> Vec<String> {
    match &*transition.from {
        [] if transition.number == 0 => vec!["[*]".into()],
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
