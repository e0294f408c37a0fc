//! Slots: those of axes hold one module each, in others one of several is put.

use super::super::read::{Device, OpenSlot, Plug, Texts};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set, set_some};
use super::axes::Axes;
use super::draft::Block;
use super::words::in_languages;
use crate::model::ids::Siblings;

/// `[modules]`, if what is in the slots are the axes.
pub(super) fn modules(device: &Device, axes: &Axes, report: &mut Report) -> Vec<Block> {
    let names = axes.names();
    if !device.plugged.iter().all(|plug| axes.are_apart(plug.index_step, plug.pdo_step))
        || names.len() != device.plugged.len()
    {
        let slots = device.slots.iter().map(Some).chain(std::iter::repeat(None));
        for (plug, slot) in device.plugged.iter().zip(slots) {
            let facts = 2 + usize::from(slot.is_some());
            report.lose(
                plug.at,
                facts,
                "Module",
                "it stands in no slot of an axis, and is part of the device",
            );
        }
        return Vec::new();
    }
    let mut known: Vec<(&Plug, Vec<&String>)> = Vec::new();
    for (plug, name) in device.plugged.iter().zip(names) {
        match known.iter_mut().find(|(known, _)| known.ident == plug.ident) {
            Some((_, axes)) => axes.push(name),
            None => known.push((plug, vec![name])),
        }
    }
    let is_one = known.len() == 1;
    let block = |(plug, axes): (&Plug, Vec<&String>)| {
        let mut keys = vec![("name".to_owned(), Toml::text(&plug.name))];
        set_some(&mut keys, "axes", (!is_one).then(|| Toml::texts(axes)));
        Block::new("modules", Some(format!("0x{:08X}", plug.ident)), keys)
    };
    known.into_iter().map(block).collect()
}

/// `[slots]`.
pub(super) fn open(device: &Device, report: &mut Report) -> Vec<Block> {
    let mut ids = Siblings::default();
    device.open_slots.iter().map(|slot| block(slot, &mut ids, report)).collect()
}

fn block(slot: &OpenSlot, ids: &mut Siblings, report: &mut Report) -> Block {
    let name = slot.name.clone().unwrap_or_else(|| {
        report.guess(slot.at, "the name of a slot", "it has none; `Slot` is taken");
        "Slot".to_owned()
    });
    let id = ids.claim(&name);
    let mut keys = Keys::new();
    set(&mut keys, "name", Toml::text(name));
    set_some(&mut keys, "names", in_languages(&slot.names));
    if slot.min > 0 {
        set(&mut keys, "min", Toml::Integer(slot.min.into()));
    }
    set(&mut keys, "max", Toml::Integer(slot.max.into()));
    for (key, step) in [("index-step", slot.index_step), ("pdo-step", slot.pdo_step)] {
        if step > 0 {
            set(&mut keys, key, Toml::Hex(step.into(), 1));
        }
    }
    let ident = |ident: &u32| Toml::Hex((*ident).into(), 8);
    if !slot.modules.is_empty() {
        set(&mut keys, "modules", Toml::List(slot.modules.iter().map(ident).collect()));
    }
    set_some(&mut keys, "default", slot.default.as_ref().map(ident));
    if !slot.classes.is_empty() {
        set(&mut keys, "classes", Toml::List(slot.classes.iter().map(class).collect()));
    }
    Block::new("slots", Some(id), keys)
}

fn class((class, name, names): &(String, Option<String>, Texts)) -> Toml {
    let mut keys = vec![("class".to_owned(), Toml::text(class))];
    set_some(&mut keys, "name", name.as_ref().map(Toml::text));
    set_some(&mut keys, "names", in_languages(names));
    Toml::Table(keys)
}
