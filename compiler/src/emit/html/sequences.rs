//! How to bring a drive into operation, out of a fault and into a mode, and how to set its reference: the words to write and what to
//! wait for, as far as the description has the facts.

mod modes;
mod ways;

use serde::Serialize;

use crate::emit::markdown::Holds;
use crate::model::{Device, Family, Index};

/// The state in which a drive waits for a reset.
const FAULT: &str = "fault";

/// The code of the last error.
const ERROR_CODE: Index = Index(0x603F);

/// The sequences of members that have the same ones.
#[derive(Debug, Serialize)]
pub(super) struct Group {
    /// The names of the members; none if these are all.
    members: String,
    /// The same as an attribute.
    holds: String,
    /// What tells its places from those of other groups.
    suffix: String,
    sequences: Vec<Sequence>,
}

/// A table of steps.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
struct Sequence {
    /// What links call it.
    id: &'static str,
    title: &'static str,
    about: &'static str,
    /// What the rows begin with.
    head: &'static str,
    rows: Vec<(String, Vec<String>)>,
}

/// The sequences of a family; those of members that have the same stand once.
pub(super) fn groups(family: &Family) -> Vec<Group> {
    let mut groups: Vec<(Vec<usize>, Vec<Sequence>)> = Vec::new();
    for (member, device) in family.members.iter().enumerate() {
        let own = sequences(device);
        match groups.iter_mut().find(|(_, same)| *same == own) {
            Some((members, _)) => members.push(member),
            None => groups.push((vec![member], own)),
        }
    }
    let is_one = groups.len() == 1;
    let name = |member: &usize| family.members.get(*member).map_or("", |device| device.name.as_str());
    let groups = groups.into_iter().filter(|(_, sequences)| !sequences.is_empty());
    let view = |(members, sequences): (Vec<usize>, Vec<Sequence>)| match is_one {
        true => Group { members: String::new(), holds: String::new(), suffix: String::new(), sequences },
        false => Group {
            suffix: members.first().map_or(String::new(), |first| format!("-{first}")),
            members: members.iter().map(name).collect::<Vec<_>>().join(", "),
            holds: Holds::for_members(&members).to_string(),
            sequences,
        },
    };
    groups.map(view).collect()
}

fn sequences(device: &Device) -> Vec<Sequence> {
    let all = [into_operation(device), out_of_a_fault(device), modes::start(device), modes::home(device)];
    all.into_iter().filter(|sequence| !sequence.rows.is_empty()).collect()
}

fn into_operation(device: &Device) -> Sequence {
    let steps = |way: &ways::Way| way.steps.iter().map(ToString::to_string).collect();
    Sequence {
        id: "into-operation",
        title: "Into operation",
        about: "What to write into the controlword, from each state, until the drive follows its set values. In bits, x is \
                left open, r rises and f falls.",
        head: "From",
        rows: ways::ways(device).iter().map(|way| (way.from.clone(), steps(way))).collect(),
    }
}

/// The way out of a fault, with what tells why it is there.
fn out_of_a_fault(device: &Device) -> Sequence {
    let ways = ways::ways(device);
    let way = ways.iter().find(|way| way.id == FAULT);
    let code = device.object(ERROR_CODE).map(|object| format!("read {}, {}", object.index, object.name));
    let row = |way: &ways::Way| {
        let reset = way.steps.first().map(ToString::to_string);
        (way.from.clone(), code.into_iter().chain(reset).collect())
    };
    Sequence {
        id: "out-of-a-fault",
        title: "Out of a fault",
        about: "What tells the cause, where the drive has that, and what resets the fault.",
        head: "From",
        rows: way.map(row).into_iter().collect(),
    }
}
