//! `Eeprom`: what a tool would write to the SII EEPROM.

use super::element::Element;
use super::literal::Bytes;
use crate::model::Eeprom;

/// The EEPROM, unless its first bytes are unknown: a tool that fills them with zeros would turn the device's
/// process data interface off, and one that finds no `Eeprom` leaves them alone.
pub(super) fn eeprom(eeprom: &Eeprom) -> Option<Element> {
    let known = !eeprom.config_data.0.is_empty();
    known.then(|| {
        Element::new("Eeprom")
            .child(Element::leaf("ByteSize", eeprom.size))
            .child(Element::leaf("ConfigData", Bytes(&eeprom.config_data.0)))
    })
}
