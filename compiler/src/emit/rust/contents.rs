//! All that the module of a device has.

use super::item::{Item, Space};
use super::scope::Scope;
use super::{
    Options, codes, commands, dictionary, errors, free, head, homing, images, machine, modes, objects, pdos,
    start_up, states, units, words,
};

/// The items of a device, by the modules they stand in.
pub(super) type Contents<'a> = Vec<(Space, Vec<Item<'a>>)>;

/// The items of a device, in the order in which they stand, with the modules in which they do.
pub(super) fn of<'s>(scope: &'s Scope<'_>, options: &Options) -> Contents<'s> {
    let of_machine =
        states::items(scope).into_iter().chain(commands::items(scope)).chain(modes::items(scope));
    let of_machine = of_machine.chain(machine::items(scope)).chain(homing::items(scope));
    let data = words::items(scope).into_iter().chain(codes::items(scope)).chain(pdos::items(scope));
    let data = data.chain(free::items(scope)).chain(images::items(scope)).chain([start_up::bring_up(scope)]);
    vec![
        (Space::Root, Vec::from_iter(head::axes_item(scope))),
        (Space::Objects, objects::items(scope)),
        (Space::Root, data.collect()),
        (Space::Configurations, start_up::configurations(scope)),
        (Space::Root, of_machine.chain(errors::items(scope)).collect()),
        (Space::Units, units::items(scope)),
        (Space::Dictionary, if options.dictionary { dictionary::items(scope) } else { Vec::new() }),
    ]
}
