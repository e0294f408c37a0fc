//! The first 64 words: what the controller takes its registers from, who the device is, and its mailbox.

use crate::model::{Device, Eeprom, Protocol, Role};

/// Its length.
pub(super) const BYTES: usize = 128;

/// The bytes that the checksum is about: PDI control to alias address, and two words that controllers use differently.
const CHECKED: usize = 14;

/// The version of the layout.
const VERSION: u16 = 1;

/// The header of an EEPROM of `size` bytes. Of `config_data` counts what stands in front of the checksum; what it lacks is
/// 0. Delays are not described.
pub(super) fn header(device: &Device, config_data: &[u8], size: u32) -> Vec<u8> {
    let mut bytes: Vec<u8> = config_data.iter().copied().take(CHECKED).collect();
    bytes.resize(CHECKED, 0);
    bytes.extend([checksum(&bytes), 0]);
    let identity = &device.identity;
    for number in [identity.vendor_id, identity.product_code, identity.revision, identity.serial] {
        bytes.extend(number.to_le_bytes());
    }
    const BOOT_MAILBOX: usize = 0x14 * 2;
    bytes.resize(BOOT_MAILBOX, 0);
    for (address, size) in device.eeprom.boot_mailbox().into_iter().flatten() {
        bytes.extend(address.to_le_bytes());
        bytes.extend(size.to_le_bytes());
    }
    const MAILBOX: usize = 0x18 * 2;
    bytes.resize(MAILBOX, 0);
    for role in [Role::MailboxOut, Role::MailboxIn] {
        let manager = device.sync_manager(role).filter(|_| device.mailbox.is_some());
        bytes.extend(manager.map_or(0, |manager| manager.address).to_le_bytes());
        bytes.extend(manager.map_or(0, |manager| manager.size).to_le_bytes());
    }
    bytes.extend(protocols(device).to_le_bytes());
    bytes.resize(BYTES - 4, 0);
    let units = u16::try_from((size / Eeprom::UNIT).saturating_sub(1)).unwrap_or(u16::MAX);
    bytes.extend(units.to_le_bytes());
    bytes.extend(VERSION.to_le_bytes());
    bytes
}

/// A bit for each protocol of the mailbox.
fn protocols(device: &Device) -> u16 {
    let spoken = device.mailbox.iter().flat_map(|mailbox| &mailbox.protocols);
    spoken.fold(0, |bits, protocol| {
        bits | match protocol {
            Protocol::Aoe => 0x01,
            Protocol::Eoe => 0x02,
            Protocol::Coe => 0x04,
            Protocol::Foe => 0x08,
            Protocol::Soe => 0x10,
            Protocol::Voe => 0x20,
        }
    })
}

/// CRC-8 with polynomial 0x07 and 0xFF at the start, as it stands behind the first 14 bytes.
pub fn checksum(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0xFF, |sum, byte| {
        (0..8).fold(sum ^ byte, |sum, _| if sum & 0x80 != 0 { sum << 1 ^ 0x07 } else { sum << 1 })
    })
}
