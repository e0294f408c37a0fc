use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Address, Device, Index, Section};

rule! {
    /// A modular device tells its slots by objects (ETG.5001): 0xF000 how far apart they are and how many there can be,
    /// 0xF010 the profile of each, 0xF030 and 0xF050 the module that is expected and found in it. A master compares
    /// them with the ESI, and refuses a device that it does not take for the one described. No more modules are needed than
    /// there are places for, and the one that is there if nothing is chosen is one that fits.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [axes]
    /// names  = ["A", "B"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }]
    ///
    /// [modules.0x100]
    /// name = "Servo axis"
    ///
    /// [objects.0xF000.entries]
    /// 1 = { default = 0x10 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [axes]
    /// names  = ["A", "B"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }]
    ///
    /// [modules.0x100]
    /// name = "Servo axis"
    ///
    /// [objects.0xF000]
    /// ```
    pub(super) static RULE = "contradicted-slots", Dictionary, Warning,
        "slots are said to be what they are not by what else is described";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    places(device, report);
    let slots = device.slots_of_axes();
    let about_slots = [0xF000, 0xF010, 0xF030, 0xF050];
    let objects = device.objects.iter().filter(|object| about_slots.contains(&object.index.0));
    for entry in objects.flat_map(|object| &object.entries) {
        let Address { index, subindex } = entry.address;
        let Some(says) = entry.default.as_ref().and_then(|default| default.integer()) else { continue };
        // What is expected is what is found, or 0 until the master has said it.
        let is_expected = index.0 == 0xF030;
        let told = if is_expected { Address { index: FOUND, subindex } } else { entry.address };
        let Some(holds) = slots.value(told).map(i128::from) else { continue };
        let can_be_more = (index.0, subindex) == (0xF000, 2) && says > holds;
        if says == holds || can_be_more || is_expected && says == 0 {
            continue;
        }
        let message = format!("{} is {says:#X}, but by axes and modules it is {holds:#X}", entry.address);
        let at = entry.origin.value("default");
        let diagnostic = Diagnostic::new(&RULE, message.replace("0X", "0x"), at, "by the dictionary");
        report
            .push(entry.address, diagnostic.help("leave the default out: it follows from axes and modules"));
    }
}

/// What `[slots]` says of places and modules.
fn places(device: &Device, report: &mut Report) {
    for slot in &device.slots {
        if slot.min > slot.max {
            let message =
                format!("`{}` has {} places, of which {} need a module", slot.id, slot.max, slot.min);
            let diagnostic = Diagnostic::new(&RULE, message, slot.origin.value("min"), "more than there are")
                .label(slot.origin.value("max"), "places");
            report.push(Section::Slots.at(&slot.id).at("min"), diagnostic);
        }
        let is_strange = |module: &u32| !slot.modules.is_empty() && !slot.modules.contains(module);
        if let Some(module) = slot.default.filter(is_strange) {
            let message = format!("module 0x{module:X} is in `{}` by default, and does not fit", slot.id);
            let diagnostic = Diagnostic::new(&RULE, message, slot.origin.value("default"), "by default")
                .label(slot.origin.value("modules"), "what fits");
            report.push(Section::Slots.at(&slot.id).at("default"), diagnostic);
        }
    }
}

/// The object that lists the modules there are.
const FOUND: Index = Index(0xF050);
