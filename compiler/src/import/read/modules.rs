//! Modules that are in the slots of a device by default: what they bring is there like what the device has itself.

use super::element::Element;
use super::esi::{Device, Object, OpenSlot, Pdo, Plug};
use super::number::{number, truth};
use super::{dictionary, process_data, words};

/// A module in its slot.
struct Plugged<'e, 't> {
    module: &'e Element<'t>,
    /// How much further its PDOs and its objects lie than those of the first slot.
    pdos: u16,
    objects: u16,
}

/// Adds what the modules in the slots bring, if each slot has exactly one, and the file says which. Gives back the modules,
/// each once.
pub(super) fn plug<'e, 't>(
    root: &'e Element<'t>,
    device: &'e Element<'t>,
    into: &mut Device,
) -> Vec<&'e Element<'t>> {
    let Some(plugged) = plugged(root, device) else {
        into.open_slots = open_slots(device);
        return Vec::new();
    };
    let Some(slots) = device.child("Slots") else { return Vec::new() };
    for name in ["SlotPdoIncrement", "SlotIndexIncrement", "MaxSlotCount"] {
        slots.attribute(name);
    }
    for slot in slots.all("Slot") {
        slot.attribute("MinInstances");
        slot.attribute("MaxInstances");
        slot.attribute_as("SlotGroup", |text| number(text).filter(|it: &u32| *it == 0));
        into.slots.extend(words::name(slot, "Name"));
        if let Some(chosen) = slot.children().iter().find(|child| is_default(child)) {
            // Those that could be there instead stay unread.
            chosen.text();
            chosen.attribute("Default");
        }
    }
    let step = |name| slots.attribute_as(name, number).unwrap_or(0);
    let plug = |it: &Plugged<'_, '_>| {
        let kind = it.module.child("Type")?;
        let name = words::name(it.module, "Name").unwrap_or_else(|| kind.text().to_owned());
        // What is said twice says nothing more.
        if kind.plain() == name {
            kind.text();
        }
        Some(Plug {
            at: it.module.at(),
            ident: kind.attribute_as("ModuleIdent", self::number)?,
            name,
            index_step: step("SlotIndexIncrement"),
            pdo_step: step("SlotPdoIncrement"),
        })
    };
    into.plugged = plugged.iter().filter_map(plug).collect();
    let mut modules: Vec<&Element<'_>> = Vec::new();
    for it in plugged {
        if !modules.iter().any(|known| std::ptr::eq(*known, it.module)) {
            modules.push(it.module);
        }
        into.rx_pdos.extend(it.module.all("RxPdo").filter_map(|pdo| shifted_pdo(pdo, &it)));
        into.tx_pdos.extend(it.module.all("TxPdo").filter_map(|pdo| shifted_pdo(pdo, &it)));
        into.objects.extend(objects(&it));
    }
    modules
}

/// The slots whose modules are to be chosen.
fn open_slots(device: &Element<'_>) -> Vec<OpenSlot> {
    let Some(slots) = device.child("Slots") else { return Vec::new() };
    let common = |name| slots.attribute_as(name, number).unwrap_or(0);
    let (pdos, objects) = (common("SlotPdoIncrement"), common("SlotIndexIncrement"));
    let open: Vec<OpenSlot> = slots.all("Slot").map(|slot| open_slot(slot, pdos, objects)).collect();
    // How many slots there are in all follows from how many there are of each kind.
    let most = open.iter().map(|slot| u32::from(slot.max)).sum::<u32>();
    slots.attribute_as("MaxSlotCount", |text| number(text).filter(|count: &u32| *count == most));
    // What says nothing: no groups, and that modules are known by their numbers.
    for name in ["MaxSlotGroupCount", "SlotGroupPdoIncrement", "SlotGroupIndexIncrement"] {
        slots.attribute_as(name, |text| number(text).filter(|it: &u32| *it == 0));
    }
    slots.attribute_as("IdentifyModuleBy", |text| (text == "ModuleIdent").then_some(()));
    open
}

fn open_slot(slot: &Element<'_>, pdos: u16, objects: u16) -> OpenSlot {
    let of = |name| slot.attribute_as(name, number);
    let idents = || slot.all("ModuleIdent").filter_map(|it| Some((number(it.text())?, it)));
    let class = |class: &Element<'_>| {
        let word = class.child("Class")?.text().to_owned();
        Some((word, words::name(class, "Name"), words::others(class, "Name")))
    };
    slot.attribute_as("SlotGroup", |text| number(text).filter(|it: &u32| *it == 0));
    OpenSlot {
        at: slot.at(),
        name: words::name(slot, "Name"),
        names: words::others(slot, "Name"),
        min: of("MinInstances").unwrap_or(0),
        max: of("MaxInstances").unwrap_or(1),
        index_step: of("SlotIndexIncrement").unwrap_or(objects),
        pdo_step: of("SlotPdoIncrement").unwrap_or(pdos),
        modules: idents().map(|(ident, _)| ident).collect(),
        default: idents().find(|(_, it)| it.attribute_as("Default", truth) == Some(true)).map(|(it, _)| it),
        classes: slot.all("ModuleClass").filter_map(class).collect(),
    }
}

fn is_default(child: &Element<'_>) -> bool {
    child.name() == "ModuleIdent" && (child.has("Default", "1") || child.has("Default", "true"))
}

/// The module of each slot; none if it is open which one a slot has.
fn plugged<'e, 't>(root: &'e Element<'t>, device: &'e Element<'t>) -> Option<Vec<Plugged<'e, 't>>> {
    let slots = device.children().iter().find(|child| child.name() == "Slots")?;
    let descriptions = root.child("Descriptions")?;
    let modules: Vec<&Element<'_>> =
        descriptions.child("Modules").into_iter().flat_map(|modules| modules.all("Module")).collect();
    let step = |name| slots.attribute_as(name, number::<u16>).unwrap_or(0);
    let (pdos, objects) = (step("SlotPdoIncrement"), step("SlotIndexIncrement"));
    let places = slots.children().iter().filter(|child| child.name() == "Slot");
    (0_u16..)
        .zip(places)
        .map(|(number, slot)| {
            let is_there = slot.has("MinInstances", "1") && slot.has("MaxInstances", "1");
            let chosen = slot.children().iter().find(|child| is_default(child)).filter(|_| is_there)?;
            let ident: u32 = self::number(chosen.plain())?;
            let is_it = |module: &&&Element<'_>| {
                let kind = module.children().iter().find(|child| child.name() == "Type");
                kind.is_some_and(|kind| kind.attribute_as("ModuleIdent", self::number) == Some(ident))
            };
            let module = *modules.iter().find(is_it)?;
            let by = |step: u16| number.checked_mul(step);
            Some(Plugged { module, pdos: by(pdos)?, objects: by(objects)? })
        })
        .collect()
}

/// Whether an index counts from slot to slot.
fn depends(parent: &Element<'_>) -> bool {
    let index = parent.child("Index");
    index.and_then(|index| index.attribute_as("DependOnSlot", truth)).unwrap_or(false)
}

fn shifted_pdo(element: &Element<'_>, plugged: &Plugged<'_, '_>) -> Option<Pdo> {
    let mut pdo = process_data::pdo(element)?;
    if depends(element) {
        pdo.index = pdo.index.checked_add(plugged.pdos)?;
    }
    for ((excluded, _), written) in pdo.excludes.iter_mut().zip(element.all("Exclude")) {
        if written.attribute_as("DependOnSlot", truth).unwrap_or(false) {
            *excluded = excluded.checked_add(plugged.pdos)?;
        }
    }
    for (entry, written) in pdo.entries.iter_mut().zip(element.all("Entry")) {
        if entry.index > 0 && depends(written) {
            entry.index = entry.index.checked_add(plugged.objects)?;
        }
    }
    Some(pdo)
}

fn objects(plugged: &Plugged<'_, '_>) -> Vec<Object> {
    let dictionary = plugged.module.child("Profile").and_then(|profile| profile.child("Dictionary"));
    let Some(dictionary) = dictionary else { return Vec::new() };
    let written = dictionary.child("Objects").into_iter().flat_map(|objects| objects.all("Object"));
    let moved: Vec<u16> = written
        .filter(|object| depends(object))
        .filter_map(|object| object.child_as("Index", number))
        .collect();
    let (mut objects, _) = dictionary::objects(dictionary);
    for object in objects.iter_mut().filter(|object| moved.contains(&object.index)) {
        object.index = object.index.saturating_add(plugged.objects);
    }
    objects
}
