//! Which device of a file is meant.

use super::Refusal;
use super::read::Head;
use crate::text::characters::harmless;

/// What a user says of the device.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Choice {
    /// Its number in the file, counted from 1, or its type or name.
    pub device: Option<String>,
    /// Its revision; the newest if absent.
    pub revision: Option<u32>,
}

impl Choice {
    /// The places of the devices in the file: of one device, or of several that may be a family.
    pub(super) fn of(&self, heads: &[Head]) -> Result<Vec<usize>, Refusal> {
        let mut left: Vec<(usize, &Head)> = heads.iter().enumerate().collect();
        if let Some(wanted) = &self.device {
            left = named(&left, wanted);
        }
        if let Some(revision) = self.revision {
            left.retain(|(_, head)| head.revision == revision);
        }
        let mut newest: Vec<(usize, &Head)> = Vec::new();
        for (place, head) in left {
            match newest.iter_mut().find(|(_, known)| is_same(known, head)) {
                Some(known) if head.revision > known.1.revision => *known = (place, head),
                Some(_) => {}
                None => newest.push((place, head)),
            }
            if newest.len() > MOST_MEMBERS {
                break;
            }
        }
        match newest.len() {
            0 if heads.is_empty() => Err(refusal("it has no device", heads)),
            0 => Err(refusal("it has no such device", heads)),
            1..=MOST_MEMBERS => Ok(newest.into_iter().map(|(place, _)| place).collect()),
            _ => Err(several(heads)),
        }
    }
}

/// How many devices are tried as a family.
const MOST_MEMBERS: usize = 16;

/// How many devices are listed.
const MOST_CHOICES: usize = 500;

/// That a file has several devices that are no family.
pub(super) fn several(heads: &[Head]) -> Refusal {
    refusal("it has several devices", heads)
}

fn refusal(why: &str, heads: &[Head]) -> Refusal {
    let choices = heads.iter().enumerate().take(MOST_CHOICES).map(|(place, head)| line(place, head));
    let rest = heads.len().saturating_sub(MOST_CHOICES);
    let rest = (rest > 0).then(|| format!("and {rest} more"));
    Refusal { place: None, why: why.to_owned(), choices: choices.chain(rest).collect() }
}

/// Whether two are versions of one device.
fn is_same(one: &Head, other: &Head) -> bool {
    one.product_code == other.product_code && one.type_name == other.type_name
}

/// Those of a number, else those of a type or name, else those whose type or name begins so.
fn named<'h>(heads: &[(usize, &'h Head)], wanted: &str) -> Vec<(usize, &'h Head)> {
    let number = wanted.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
    if let Some(head) = number.and_then(|number| heads.get(number)) {
        return vec![*head];
    }
    let find = |fits: &dyn Fn(&str) -> bool| -> Vec<(usize, &'h Head)> {
        heads.iter().copied().filter(|(_, head)| fits(&head.type_name) || fits(&head.name)).collect()
    };
    let lower = wanted.to_lowercase();
    let exact = find(&|name| name.to_lowercase() == lower);
    if exact.is_empty() { find(&|name| name.to_lowercase().starts_with(&lower)) } else { exact }
}

fn line(place: usize, head: &Head) -> String {
    let code = head.product_code.unwrap_or(0);
    let named = if head.name == head.type_name { String::new() } else { format!(", {}", head.name) };
    let line = format!(
        "{}: {}{named}, product 0x{code:08X}, revision 0x{:08X}",
        place + 1,
        head.type_name,
        head.revision
    );
    harmless(&line).into_owned()
}
