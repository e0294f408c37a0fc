//! An image that somebody else's tool made and somebody else's boards carry: where the facts are the same, the bytes are.
//!
//! The board is EaserCAT 3000 of MetalMusings, whose repository `MyOwnEtherCATDevice` has the image as Intel hex beside the
//! firmware. Two things differ on purpose: it leaves its first mapping unit unused, and it has process data of no bytes,
//! since the firmware sets the lengths.

use crate::corners::compiled;
use crate::reader::Image;

/// Words 0x00 to 0x3F as published, without zeros from 0x20 to 0x3D.
const HEAD: &str = "050603446400000000001A0000004E00AA0A0000AEDCCA000100000001000000\
    00000000000000000000000000000000001000020012000204";
const SIZE_AND_VERSION: [u16; 2] = [0x000F, 1];
/// The mailbox and the places of process data: address, length, control, status, enable, type.
const SYNC_MANAGERS: &str = "001000022600010100120002220001020016000024000103001A000020000104";

const BOARD: &str = r#"
    [device]
    name = "MetalMusings EaserCAT 3000"
    vendor = "MetalMusings"
    group = "CNC control"
    type-name = "MachineControl"
    physics = "YY"

    [identity]
    vendor-id = 0xAAA
    product-code = 0xCADCAE
    revision = 1
    serial = 1

    [eeprom]
    size = 2048
    config-data = "050603446400000000001A000000"

    [mailbox]
    protocols = ["CoE"]
    sdo-info = true
    pdo-upload = true

    [objects]
    0x1000 = { name = "Device type", type = "UINT32", default = 0x1389 }
    0x6000 = { name = "Position", type = "INT32", pdo = "tx" }
    0x7000 = { name = "Speed", type = "INT32", access = "rw", pdo = "rx" }

    [objects.0x1018]
    name = "Identity"
    kind = "record"
    type = "UINT32"
    entries = { "1..=4" = { name = "Number" } }

    [rx-pdos.0x1600]
    name = "Speed"
    entries = ["0x7000"]
    fixed = true

    [tx-pdos.0x1A00]
    name = "Position"
    entries = ["0x6000"]
    fixed = true

    [sync-managers]
    mailbox-out = { address = 0x1000, size = 512 }
    mailbox-in = { address = 0x1200, size = 512, control = 0x22 }
    outputs = { address = 0x1600, control = 0x24, pdos = ["0x1600"] }
    inputs = { address = 0x1A00, pdos = ["0x1A00"] }
"#;

fn bytes(hex: &str) -> Vec<u8> {
    let digits: Vec<_> = hex.chars().filter_map(|digit| digit.to_digit(16)).collect();
    digits.chunks(2).map(|pair| u8::try_from(pair[0] * 16 + pair[1]).unwrap()).collect()
}

fn image() -> Image {
    let family = compiled(BOARD);
    let device = family.members.first().unwrap();
    Image::read(&devc::sii::image(device, &device.eeprom.config_data.0).unwrap())
}

#[test]
fn the_words_of_the_head_are_those_of_a_published_image() {
    let mut expected: Vec<u16> = bytes(HEAD)
        .chunks(2)
        .map(|pair| pair.iter().rev().fold(0, |word, byte| word << 8 | u16::from(*byte)))
        .collect();
    expected.resize(0x3E, 0);
    expected.extend(SIZE_AND_VERSION);
    assert_eq!(image().words, expected);
}

#[test]
fn sync_managers_are_those_of_a_published_image_but_for_the_lengths_of_process_data() {
    let image = image();
    let published = bytes(SYNC_MANAGERS);
    let rows = image.category(41).unwrap().chunks(8).zip(published.chunks(8));
    for (number, (row, published)) in rows.enumerate() {
        let mut row = row.to_vec();
        if number > 1 {
            assert_eq!(row[2..4], [4, 0], "one value of 32 bits");
            row[2..4].fill(0);
        }
        assert_eq!(row, published);
    }
}

#[test]
fn general_information_is_that_of_a_published_image_but_for_the_numbers_of_strings() {
    let image = image();
    let general = image.category(30).unwrap();
    assert_eq!(general.len(), 32);
    assert_eq!(general[5], 0x13, "SDO, SDO information, and PDOs are uploaded");
    assert_eq!(general[6..11], [0; 5], "no FoE, no EoE, no channels");
    assert_eq!(general[16..18], [0x11, 0x00], "two ports of 100BASE-TX");
    let names = [0, 3].map(|place| image.string(general[place]));
    assert_eq!(names, ["CNC control", "MetalMusings EaserCAT 3000"]);
}
