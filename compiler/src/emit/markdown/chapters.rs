//! The chapters, one file each.

mod axes;
mod communication;
mod configurations;
mod connections;
mod coordinates;
mod device;
mod errors;
mod homing;
mod modes;
mod objects;
mod process_data;
mod registers;
mod service;
mod sources;
mod states;
mod stopping;
mod synchronisation;
mod units;
mod words;

use super::context::Context;
use super::document::{Prepared, prepare};

/// Makes a chapter, if there is anything to show.
type Prepare = fn(&Context<'_>) -> Option<Prepared>;

/// The chapters of a device, in the order of the document.
pub(super) fn chapters(context: &Context<'_>) -> impl Iterator<Item = Prepared> {
    CHAPTERS.iter().filter_map(|chapter| chapter(context))
}

/// All chapters, in the order of the document.
static CHAPTERS: &[Prepare] = &[
    prepare::<device::View>,
    prepare::<axes::View>,
    prepare::<connections::View>,
    prepare::<communication::View>,
    prepare::<synchronisation::View>,
    prepare::<process_data::View>,
    prepare::<configurations::View>,
    prepare::<words::View>,
    prepare::<states::View>,
    prepare::<modes::View>,
    prepare::<homing::View>,
    prepare::<stopping::View>,
    prepare::<errors::View>,
    prepare::<units::View>,
    prepare::<coordinates::View>,
    prepare::<objects::View>,
    prepare::<registers::View>,
    prepare::<service::View>,
    prepare::<sources::View>,
];
