//! Several members as one document: what they share once, and what tells them apart first.

mod align;
mod differences;
mod merge;
mod names;
mod rows;
mod sections;
mod sentences;

use super::holds::Form;
use super::inline::text;
use super::page::Page;
use crate::model::{Device, Family};

/// What stands before the chapters.
pub(super) fn front(family: &Family, page: &mut Page) {
    page.heading(1, text(&family.name));
    family.about.iter().for_each(|about| page.text(text(about)));
    page.text("What tells the members apart:");
    page.table(differences::table(family, &names(family)));
    page.text("Whatever follows holds for all of them unless members are named.");
}

/// The chapters of the members as one.
pub(super) fn body(family: &Family, bodies: Vec<Page>, form: Form) -> Page {
    merge::merge(&names(family), form, bodies)
}

/// What members are called in passing: their name if that is one word, else their id.
fn names(family: &Family) -> Vec<String> {
    let name = |device: &Device| text(if device.name.contains(' ') { &device.id } else { &device.name });
    family.members.iter().map(name).collect()
}
