//! EEPROM images for tests, written after ETG.1000.6 and ETG.2010: what a master needs to find a device.

use devc_runtime::esm::{Area, Areas, Manager};

/// The image of a device with a CoE mailbox.
pub(crate) fn of(name: &str, identity: [u32; 3], areas: &Areas, lengths: (usize, usize)) -> Vec<u8> {
    let mut image = vec![0; 128];
    image[0..2].copy_from_slice(&[0x08, 0x0C]);
    image[8..10].copy_from_slice(&0x0123_u16.to_le_bytes());
    image[14] = crc8(&image[..14]);
    for (number, place) in identity.iter().zip((16..).step_by(4)) {
        image[place..place + 4].copy_from_slice(&number.to_le_bytes());
    }
    let [out, into, outputs, inputs] = *areas.managers else { panic!("four sync managers") };
    for (manager, place) in [out, into].into_iter().zip([0x30, 0x34]) {
        let Area { address, length: (_, length) } = manager.area;
        image[place..place + 2].copy_from_slice(&address.to_le_bytes());
        image[place + 2..place + 4].copy_from_slice(&length.to_le_bytes());
    }
    image[0x38] = 0x04;
    image[0x7C] = 15;
    image[0x7E] = 1;
    let name = &name[..name.len().min(64)];
    let mut strings = vec![1, name.len() as u8];
    strings.extend(name.as_bytes());
    let mut general = [0; 32];
    // order and name, what CoE can, and the sync managers
    (general[2], general[3], general[5], general[11]) = (1, 1, 0x1F, 1);
    general[16] = 0x11;
    let managers = [
        manager(out, None, 0x26, 1),
        manager(into, None, 0x22, 2),
        manager(outputs, Some(lengths.0), 0x64, 3),
        manager(inputs, Some(lengths.1), 0x20, 4),
    ];
    category(&mut image, 10, &strings);
    category(&mut image, 30, &general);
    category(&mut image, 40, &[1, 2, 3]);
    category(&mut image, 41, &managers.concat());
    image.extend([0xFF; 2]);
    image
}

fn manager(manager: Manager, length: Option<usize>, control: u8, kind: u8) -> [u8; 8] {
    let Area { address, length: (_, longest) } = manager.area;
    let [address_low, address_high] = address.to_le_bytes();
    let [low, high] = length.map_or(longest, |length| length as u16).to_le_bytes();
    [address_low, address_high, low, high, control, 0, 1, kind]
}

fn category(image: &mut Vec<u8>, number: u16, data: &[u8]) {
    image.extend(number.to_le_bytes());
    image.extend((data.len().div_ceil(2) as u16).to_le_bytes());
    image.extend(data);
    image.resize(image.len().next_multiple_of(2), 0xFF);
}

/// CRC-8, bit by bit: polynomial x^8 + x^2 + x + 1, begun with 0xFF.
fn crc8(bytes: &[u8]) -> u8 {
    let mut crc = 0xFF_u8;
    for bit in bytes.iter().flat_map(|byte| (0..8).rev().map(move |bit| byte >> bit & 1)) {
        let carry = crc >> 7 ^ bit;
        crc = crc << 1 ^ (carry * 0x07);
    }
    crc
}
