//! `Eeprom`: what a tool would write to the SII EEPROM.

use super::element::Element;
use super::literal::Bytes;
use crate::model::Eeprom;

/// The EEPROM, if anything is said of it. Its first bytes are there as far as they are known: a guess could turn the
/// device's process data interface off, so that unknown ones are left out, and a rule has asked for them.
pub(super) fn eeprom(eeprom: &Eeprom) -> Option<Element> {
    let boot = !eeprom.bootstrap.0.is_empty();
    eeprom.is_described().then(|| {
        Element::new("Eeprom")
            .child(Element::leaf("ByteSize", eeprom.size))
            .child(Element::leaf("ConfigData", Bytes(&eeprom.config_data.0)))
            .child(boot.then(|| Element::leaf("BootStrap", Bytes(&eeprom.bootstrap.0))))
    })
}
