use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::lint::occupant::{Occupant, unlike};
use crate::model::{Device, Module, Section};

rule! {
    /// A module stands once in an ESI, for all slots that it is in, of all members of a family: a master takes it by its
    /// number. So what its axes have must be the same: an axis that lacks an object, or has another type or default, is
    /// another module.
    ///
    /// ## Fires
    /// ```toml
    /// [axes]
    /// names  = ["A", "B"]
    /// shifts = [{ range = "0x2000..=0x27FF", by = 0x800 }]
    ///
    /// [modules.0x100]
    /// name = "Servo axis"
    ///
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT16"
    /// per-axis.B = { type = "UINT32", note = "The second axis is slower." }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [axes]
    /// names  = ["A", "B"]
    /// shifts = [{ range = "0x2000..=0x27FF", by = 0x800 }]
    ///
    /// [modules]
    /// 0x100 = { name = "Servo axis", axes = ["A"] }
    /// 0x101 = { name = "Slow servo axis", axes = ["B"] }
    ///
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT16"
    /// per-axis.B = { type = "UINT32", note = "The second axis is slower." }
    /// ```
    pub(crate) static RULE = "unlike-slots", Output, Error,
        "axes or members share a module, but are not alike";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for module in &device.modules {
        let axes = device.axes_of(module);
        let occupants: Vec<_> = axes.map(|axis| Occupant::new(device, module, axis)).collect();
        let Some((first, others)) = occupants.split_first() else { continue };
        let members = between_members(device, module, first, report);
        for diagnostic in between_axes(module, first, others).chain(members) {
            report.push(Section::Modules.at(module.ident), diagnostic);
        }
    }
}

/// How the other axes that are such a module differ from the first.
fn between_axes(module: &Module, first: &Occupant, others: &[Occupant]) -> impl Iterator<Item = Diagnostic> {
    others.iter().filter_map(|other| {
        let diagnostic = judge(module, [first, other], "axes", [&first.axis, &other.axis])?;
        Some(diagnostic.help(format!("give `{}` a module of its own", other.axis)))
    })
}

/// How the module differs from that of the first member that has it.
fn between_members(device: &Device, module: &Module, mine: &Occupant, report: &Report) -> Option<Diagnostic> {
    let earlier =
        report.earlier().iter().flat_map(|member| member.occupants.iter().map(move |it| (member, it)));
    let (member, first) = earlier.into_iter().find(|(_, occupant)| occupant.module == module.ident)?;
    let diagnostic = judge(module, [first, mine], "members", [&member.id, &device.id])?;
    Some(diagnostic.help("give the module of one of them a number of its own"))
}

/// What is wrong with two that share a module.
fn judge(module: &Module, two: [&Occupant; 2], kind: &str, names: [&str; 2]) -> Option<Diagnostic> {
    let (what, at) = unlike(two, names)?;
    let [first, other] = names;
    let message = format!("{kind} `{first}` and `{other}` share the module `{}`, but {what}", module.name);
    let diagnostic = Diagnostic::new(&RULE, message, at, "not the same on both");
    Some(diagnostic.label(module.origin.header(), "the module of both"))
}
