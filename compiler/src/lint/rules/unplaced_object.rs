use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Area, Device, Index, Repeated};

rule! {
    /// `[areas]` says which indices a device uses for what. Where it divides a part of the dictionary, be it that for
    /// communication, for the manufacturer or for the profile, an object of that part outside of the areas has a
    /// misprint in its index, or the areas are too narrow.
    ///
    /// ## Fires
    /// ```toml
    /// [areas."0x2000..=0x2FFF"]
    /// name = "Manufacturer"
    ///
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "INT16" }
    /// 0x3000 = { name = "Torque", type = "INT16" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [areas."0x2000..=0x3FFF"]
    /// name = "Manufacturer"
    ///
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "INT16" }
    /// 0x3000 = { name = "Torque", type = "INT16" }
    /// ```
    pub(super) static RULE = "unplaced-object", Dictionary, Warning, "an object lies in none of the areas";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.areas.is_empty() {
        return;
    }
    for object in lookup::objects(device) {
        let index = object.index;
        let Some(area) = nearest(device, index).filter(|area| object.is_leading() && !holds(area, index))
        else {
            continue;
        };
        let message = format!("{index} `{}` lies in none of the areas", object.name);
        let diagnostic = Diagnostic::new(&RULE, message, object.origin.header(), "outside")
            .label(area.origin.header(), format!("`{}` is {} to {}", area.name, area.first, area.last))
            .help("widen the area, or add one");
        report.push(index, diagnostic);
    }
}

/// The nearest area in the same part of the dictionary; a part without areas is not divided.
fn nearest(device: &Device, index: Index) -> Option<&Area> {
    let areas =
        device.areas.iter().filter(|area| part(area.first) <= part(index) && part(index) <= part(area.last));
    areas.min_by_key(|area| {
        if holds(area, index) { 0 } else { area.first.0.abs_diff(index.0).min(area.last.0.abs_diff(index.0)) }
    })
}

fn holds(area: &Area, index: Index) -> bool {
    (area.first..=area.last).contains(&index)
}

/// The parts of the dictionary by CiA 301: data types, communication, manufacturer, profile.
fn part(index: Index) -> u8 {
    match index.0 {
        0x0000..=0x0FFF => 0,
        0x1000..=0x1FFF => 1,
        0x2000..=0x5FFF => 2,
        0x6000.. => 3,
    }
}
