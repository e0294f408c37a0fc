//! Outputs that have a file for each way to set a device up, and what raw values are in them.

use devc::emit::{Emitter, Options};
use serde_json::Value as Json;

use crate::model::{list, name, subjects, text};

/// Checks the file of each member and of each of its configurations, and that there is no other.
pub(crate) fn each_file(emitter: &dyn Emitter, check: impl Fn(&str, &[u8], &Json, Option<&Json>)) {
    let end = emitter.ends()[0];
    for subject in subjects() {
        let files = emitter.emit(&subject.family, &Options::default()).0;
        let mut count = 0;
        for member in &subject.members {
            let configurations = list(member, "configurations");
            let default = configurations.iter().find(|it| it["default"] == true);
            let others = configurations.iter().filter(|it| it["default"] != true);
            for configuration in std::iter::once(default).chain(others.map(Some)) {
                let own = configuration.filter(|it| it["default"] != true);
                let own = own.map(|it| format!("-{}", name(text(it, "id"), &[]))).unwrap_or_default();
                let file = format!("{}{own}{end}", text(member, "id"));
                check(&file, &files[&file], member, configuration);
                count += 1;
            }
        }
        assert_eq!(files.len(), count, "files of {}", subject.id);
    }
}

/// The symbol of what is mapped, and how many of it a raw step is.
pub(crate) fn step<'j>(member: &'j Json, mapped: &Json) -> Option<(&'j str, f64)> {
    let object = list(member, "objects").iter().find(|it| it["index"] == mapped["address"]["index"])?;
    let entry = list(object, "entries").iter().find(|it| it["address"] == mapped["address"])?;
    let unit = list(member, "units").iter().find(|unit| unit["id"] == entry["unit"])?;
    let axis = object["axis"].as_u64().map_or(0, |axis| usize::try_from(axis).unwrap());
    let unit = list(unit, "axes").get(axis).or(list(unit, "axes").first())?;
    let scale = &unit["scale"];
    let ratio = scale["units"].as_f64().zip(scale["raw"].as_f64()).map_or(1.0, |(units, raw)| units / raw);
    Some((text(unit, "symbol"), ratio))
}
