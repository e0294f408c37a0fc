//! What the shipped devices have not, byte by byte as ETG.1000.6 and ETG.2010 have it.

use std::path::Path;

use devc::lint::Checked;
use devc::model::Family;
use devc::source::Memory;

use crate::reader::{Entry, Image};

const CORNER: &str = include_str!("corner.toml");

pub(crate) fn compiled(text: &str) -> Checked<Family> {
    let folder = Path::new("/corner");
    let compilation = devc::compile(&Memory::new().with(folder.join("device.toml"), text), folder);
    let messages: Vec<_> = compilation.diagnostics.iter().map(|it| it.message.as_str()).collect();
    compilation.family.unwrap_or_else(|| panic!("{messages:#?}"))
}

fn image(text: &str) -> Image {
    let family = compiled(text);
    let device = family.members.first().unwrap();
    Image::read(&devc::sii::image(device, &device.eeprom.config_data.0).unwrap())
}

#[test]
fn the_header_takes_what_is_described() {
    let image = image(CORNER);
    assert_eq!(
        image.words[..7],
        [0x0C05, 0x8803, 0, 0, 0, 0x00A0, 0x1234],
        "the seven words of `config-data`"
    );
    assert_eq!((image.long(8), image.long(0xA), image.long(0xC)), (0xFFFF_FFFF, 0x8000_0001, 0x0001_0002));
    assert_eq!(image.long(0xE), 77, "the serial number");
    assert_eq!(
        image.words[0x14..0x18],
        [0x1000, 0x100, 0x1400, 0x200],
        "the mailbox in Bootstrap, out and in"
    );
    assert_eq!(image.words[0x1C], 0x02 + 0x04 + 0x08 + 0x10 + 0x20);
    assert_eq!(image.words[0x3E], 31, "4096 bytes are 32 KiBit, and one is not counted");
}

#[test]
fn general_information_has_its_places() {
    let image = image(CORNER);
    let data = image.category(30).unwrap();
    let [group, picture, order, name, reserved] = data[..5] else { panic!("{data:?}") };
    assert_eq!(order, 1, "SOEM calls a device by the first string");
    assert_eq!([group, order, name].map(|it| image.string(it)), ["Edges", "Type", "M?ller"]);
    assert_eq!((picture, reserved, data[14]), (0, 0, group));
    // SDO, information, assignment, configuration, complete access
    assert_eq!(data[5], 0x01 | 0x02 | 0x04 | 0x08 | 0x20);
    // FoE, EoE, a channel of SoE and one of DS402 for each of two axes, system manager, no LRW, mail is acknowledged,
    // identification by AL status and by memory
    assert_eq!(data[6..12], [1, 1, 2, 2, 0, 0x02 | 0x04 | 0x08 | 0x10]);
    // 2 mA given to the E-bus
    assert_eq!(data[12..14], [0xFE, 0xFF]);
    // 100BASE-TX, E-bus, no port, hot connect: four bits each from the lowest
    assert_eq!(data[16..18], [0x31, 0x40]);
    // where the identification is read
    assert_eq!(data[18..20], [0x12, 0]);
    assert_eq!(data[20..], [0; 12]);
}

#[test]
fn sync_managers_and_mapping_units_come_in_any_number() {
    let image = image(CORNER);
    let rows: Vec<&[u8]> = image.category(41).unwrap().chunks(8).collect();
    assert_eq!(rows[2], [0x00, 0x11, 2, 0, 0x64, 0, 1 | 8, 3], "on in Operational only");
    assert_eq!(rows[3], [0x00, 0x12, 32, 0, 0x20, 0, 1, 4]);
    assert_eq!(rows[4], [0x00, 0x14, 1, 0, 0x64, 0, 1, 3]);
    assert_eq!(image.category(40).unwrap(), [1, 1, 2, 3], "two of outputs, one of inputs, the mailbox");
}

#[test]
fn entries_of_any_width_keep_their_places() {
    let image = image(CORNER);
    let entry = |index, subindex, name: &str, data_type, bits| {
        let name = name.to_owned();
        Entry { index, subindex, name, data_type, bits }
    };
    let [inputs] = &image.pdos(50)[..] else { panic!("one PDO") };
    assert_eq!((inputs.index, inputs.sync_manager, inputs.flags), (0x1A00, 3, 0x01 | 0x02 | 0x10));
    let expected = [
        entry(0x2002, 0, "Switch", 0x01, 1),
        entry(0x2003, 0, "Level", 0x32, 3),
        entry(0, 0, "", 0, 4),
        entry(0x2004, 0, "Wide", 0x16, 24),
        entry(0x2005, 0, "Share", 0x08, 32),
        entry(0x2006, 0, "Label", 0x09, 192),
    ];
    assert_eq!(inputs.entries, expected);
    let outputs: Vec<_> = image.pdos(51).iter().map(|it| (it.index, it.sync_manager, it.flags)).collect();
    assert_eq!(outputs, [(0x1600, 2, 0x02 | 0x10), (0x1601, 4, 0x02 | 0x10), (0x1602, 0xFF, 0x10)]);
}

#[test]
fn clocks_have_periods_shifts_and_factors() {
    let image = image(CORNER);
    let rows: Vec<&[u8]> = image.category(60).unwrap().chunks(24).collect();
    let names = |row: &[u8]| [row[18], row[19]].map(|number| image.string(number).to_owned());
    assert_eq!(names(rows[0]), ["both", "Both signals"]);
    // SYNC0 every 500 us, 20 us earlier; SYNC1 every fourth of them, 1 us later
    let first =
        [&500_000_u32.to_le_bytes()[..], &(-20_000_i32).to_le_bytes(), &1_000_i32.to_le_bytes()].concat();
    assert_eq!(rows[0][..12], first);
    assert_eq!(rows[0][12..18], [4, 0, 0x00, 0x07, 0, 0]);
    // SYNC0 twice in a cycle of the master
    assert_eq!(rows[1][..12], [0; 12]);
    assert_eq!(rows[1][12..18], [0, 0, 0x00, 0x03, 0xFE, 0xFF]);
}

#[test]
fn a_device_without_mailbox_clocks_or_inputs_has_no_such_categories() {
    let bare = r#"
        [device]
        name = "Bare"
        vendor = "Example"
        [identity]
        vendor-id = 1
        product-code = 2
        revision = 3
        [eeprom]
        config-data = "040E"
        [objects]
        0x2000 = { name = "Lamps", type = "UINT8", access = "rw", pdo = "rx" }
        [rx-pdos.0x1600]
        name = "Lamps"
        entries = ["0x2000"]
        [sync-managers]
        outputs = { address = 0x1000, pdos = ["0x1600"] }
    "#;
    let image = image(bare);
    let kinds: Vec<u16> = image.categories.iter().map(|(kind, _)| *kind).collect();
    assert_eq!(kinds, [10, 30, 40, 41, 51]);
    assert_eq!(image.category(40).unwrap(), [1, 0xFF], "a unit that is not used is 0xFF");
    assert_eq!(image.words[0x14..0x1D], [0; 9], "no mailbox, no protocols");
    let general = image.category(30).unwrap();
    assert_eq!((general[5], general[11]), (0, 0));
}
