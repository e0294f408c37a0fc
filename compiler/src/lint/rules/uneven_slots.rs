use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Index, Repeated, Section};
use crate::source::Origin;

rule! {
    /// In an ESI with slots, the objects of a slot are those of the first one, moved by one number for all of them, and so
    /// are its PDOs. What is elsewhere, or carried by the PDO of another axis, has no index there.
    ///
    /// ## Fires
    /// ```toml
    /// [axes]
    /// names  = ["A", "B"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }, { range = "0x2000..=0x20FF", by = 0x100 }]
    ///
    /// [modules.0x100]
    /// name = "Servo axis"
    ///
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT16"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [axes]
    /// names  = ["A", "B"]
    /// shifts = [{ range = "0x6000..=0x67FF", by = 0x800 }, { range = "0x2000..=0x27FF", by = 0x800 }]
    ///
    /// [modules.0x100]
    /// name = "Servo axis"
    ///
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT16"
    /// ```
    pub(crate) static RULE = "uneven-slots", Output, Error,
        "what axes have is not at one distance from slot to slot";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(module) = device.modules.first() else { return };
    let Some(step) = device.arrangement.shifts.first().map(|shift| shift.by) else {
        let diagnostic = Diagnostic::new(
            &RULE,
            "nothing says how far apart the slots are",
            module.origin.header(),
            "asks for slots",
        );
        return report
            .push(Section::Modules.at(module.ident), diagnostic.help("say it in the `shifts` of `[axes]`"));
    };
    for object in device.objects.iter().filter(|object| !object.is_leading()) {
        if let Some(axis) = device.slot_of(object).filter(|axis| stray(object, *axis, step)) {
            report.push(object.index, uneven(object.index, object.leading, axis, step, &object.origin));
        }
    }
    let moved = device.arrangement.pdo_shift;
    for pdo in &device.pdos {
        let Some(axis) = pdo.axis else { continue };
        if stray(pdo, axis, moved) {
            report.push(pdo.index, uneven(pdo.index, pdo.leading, axis, moved, &pdo.origin));
        }
        let foreign = |index: Index| {
            let object = device.object(index)?;
            device.slot_of(object).filter(|other| *other != axis)
        };
        for mapped in &pdo.entries {
            if let Some(address) = mapped.address.filter(|address| foreign(address.index).is_some()) {
                let message =
                    format!("{} carries {address}, which is in the slot of another axis", pdo.index);
                report.push(
                    pdo.index,
                    Diagnostic::new(&RULE, message, mapped.origin.header(), "of another axis"),
                );
            }
        }
    }
}

fn stray(one: &dyn Repeated, axis: u8, step: u16) -> bool {
    u32::from(one.leading().0) + u32::from(axis) * u32::from(step) != u32::from(one.index().0)
}

fn uneven(index: Index, leading: Index, axis: u8, step: u16, origin: &Origin) -> Diagnostic {
    let message = format!("{index} is not {axis} × 0x{step:X} from {leading}, that of the first axis");
    Diagnostic::new(&RULE, message, origin.header(), format!("slots are 0x{step:X} apart"))
        .help("leave out `[modules]`: an ESI without slots takes axes at any distance")
}
