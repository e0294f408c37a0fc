//! EEPROM images: what is written to the EEPROM of a new device, as bytes and as Intel hex.
//!
//! There is none of a device whose first bytes are not described, and none that does not fit: `missing-config-data` and
//! `undersized-eeprom` say it.

mod intel_hex;

use super::{Emitter, Files, Options};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::{Device, Family};
use crate::sii;

/// Makes EEPROM images.
#[derive(Debug)]
pub struct Sii;

/// What it cannot hold.
const LINTS: &[&Rule] = &[
    &rules::contradicted_config_data::RULE,
    &rules::empty_name::RULE,
    &rules::impossible_boot_mailbox::RULE,
    &rules::impossible_eeprom_size::RULE,
    &rules::missing_config_data::RULE,
    &rules::overlong_name::RULE,
    &rules::undersized_eeprom::RULE,
];

impl Emitter for Sii {
    fn name(&self) -> &'static str {
        "sii"
    }

    fn summary(&self) -> &'static str {
        "EEPROM images, as bytes and as Intel hex"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".bin", ".hex"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        let images = family.members.iter().filter_map(|device| Some((&device.id, image(device)?)));
        let files = images.flat_map(|(id, image)| {
            let hex = intel_hex::text(&image).into_bytes();
            [(format!("{id}.bin"), image), (format!("{id}.hex"), hex)]
        });
        Files(files.collect())
    }
}

/// The image of a device whose first bytes are described.
fn image(device: &Device) -> Option<Vec<u8>> {
    let config_data = &device.eeprom.config_data.0;
    (!config_data.is_empty()).then(|| sii::image(device, config_data)).flatten()
}
