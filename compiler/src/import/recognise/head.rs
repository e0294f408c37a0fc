//! What the device is: names, identity, EEPROM.

use super::super::read::{Device, Esi};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set, set_some};
use super::draft::Block;
use super::literal::pairs;
use super::words::in_languages;
use crate::model::Eeprom;

/// `[device]`, `[identity]` and `[eeprom]`.
pub(super) fn blocks(esi: &Esi, device: &Device, report: &mut Report) -> Vec<Block> {
    let mut blocks = vec![self::device(esi, device, report), identity(esi, device, report)];
    if let Some(eeprom) = &device.eeprom {
        let mut keys = Keys::new();
        if let Some(size) =
            eeprom.size.filter(|size| *size != Eeprom::USUAL_SIZE || eeprom.config_data.is_empty())
        {
            set(&mut keys, "size", Toml::Integer(size.into()));
        }
        if !eeprom.config_data.is_empty() {
            set(&mut keys, "config-data", Toml::text(pairs(&eeprom.config_data)));
        } else {
            report.guess(
                eeprom.at,
                "Eeprom",
                "without ConfigData an ESI made of the description has no Eeprom",
            );
        }
        if !eeprom.bootstrap.is_empty() {
            set(&mut keys, "bootstrap", Toml::text(pairs(&eeprom.bootstrap)));
        }
        blocks.push(Block::new("eeprom", None, keys));
    }
    blocks
}

fn device(esi: &Esi, device: &Device, report: &mut Report) -> Block {
    let mut keys = Keys::new();
    let notes = report.notes.len();
    let head = &device.head;
    let name = if head.name.is_empty() { "Device".to_owned() } else { head.name.clone() };
    let vendor = esi.vendor_name.clone().filter(|name| !name.is_empty()).unwrap_or_else(|| {
        let name = format!("Vendor 0x{:08X}", esi.vendor_id.unwrap_or(0));
        report.guess(head.at, "the vendor's name", format!("the file has none; `{name}` is taken"));
        name
    });
    set(&mut keys, "name", Toml::text(&name));
    set_some(&mut keys, "names", in_languages(&device.names));
    let usual = crate::model::Device::usual_group(&vendor);
    set(&mut keys, "vendor", Toml::text(vendor));
    if let Some(group) = device.group.as_ref().filter(|group| !group.is_empty() && **group != usual) {
        set(&mut keys, "group", Toml::text(group));
    }
    if !head.type_name.is_empty() && head.type_name != name.replace(' ', "-") {
        set(&mut keys, "type-name", Toml::text(&head.type_name));
    }
    if let Some(profile) = device.profile {
        set(&mut keys, "profile", Toml::Integer(profile.into()));
    }
    match &device.physics {
        Some(physics) => set(&mut keys, "physics", Toml::text(physics)),
        None => {
            report.guess(head.at, "Physics", "it is missing, or says no ports; two for cables are taken");
            set(&mut keys, "physics", Toml::text("YY"));
        }
    }
    set_some(&mut keys, "ebus-current", device.ebus_current.map(|current| Toml::Integer(current.into())));
    if device.no_lrw {
        set(&mut keys, "no-lrw", Toml::Bool(true));
    }
    set_some(&mut keys, "url", device.url.as_ref().map(Toml::text));
    set_some(&mut keys, "urls", in_languages(&device.urls));
    Block { remarks: report.guessed_since(notes), ..Block::new("device", None, keys) }
}

fn identity(esi: &Esi, device: &Device, report: &mut Report) -> Block {
    let notes = report.notes.len();
    let mut keys = Keys::new();
    let numbers = [
        ("vendor-id", esi.vendor_id, "the vendor id"),
        ("product-code", device.head.product_code, "the product code"),
        ("revision", Some(device.head.revision), "the revision"),
    ];
    for (name, number, what) in numbers {
        if number.is_none() {
            report.guess(device.head.at, what, "it is missing or no number; 0 is taken");
        }
        set(&mut keys, name, Toml::Hex(number.unwrap_or(0).into(), 8));
    }
    if !device.replaces.is_empty() {
        let replaces = device.replaces.iter().map(|revision| Toml::Hex((*revision).into(), 8));
        set(&mut keys, "replaces", Toml::List(replaces.collect()));
    }
    let product_code = device.check_product_code.map(|it| Toml::text(it.word()));
    set_some(&mut keys, "check-product-code", product_code);
    set_some(&mut keys, "check-revision", device.check_revision.map(|it| Toml::text(it.word())));
    if device.requested_id {
        set(&mut keys, "requested-id", Toml::Bool(true));
    }
    set_some(&mut keys, "id-address", device.id_address.map(|address| Toml::Hex(address.into(), 4)));
    Block { remarks: report.guessed_since(notes), ..Block::new("identity", None, keys) }
}
