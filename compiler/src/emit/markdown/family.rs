//! Several members as one document: what they share once, and what tells them apart first.

mod align;
mod blocks;
mod differences;
mod merge;
mod names;
mod rows;
mod sentences;

use minijinja::{Value, context};

use super::inline::text;
use crate::model::{Device, Family};

/// What the template of a family shows, made of the references of its members.
pub(super) fn view(family: &Family, bodies: &[String]) -> Value {
    let names: Vec<String> = family.members.iter().map(name).collect();
    context! {
        name => text(&family.name),
        about => family.about.as_deref().map_or(String::new(), text),
        differences => differences::table(family, &names).to_string(),
        body => merge::merge(&names, bodies),
    }
}

/// What a member is called in passing: its name if that is one word, else its id.
fn name(device: &Device) -> String {
    text(if device.name.contains(' ') { &device.id } else { &device.name })
}
