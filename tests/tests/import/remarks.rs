//! What makes a description one that a person would commit: guesses beside what they are about, the modes of a drive, its
//! picture.

use devc::import::{Choice, Imported, import};

use super::round_trip::trip;
use super::transport::{file, text, value, whole};

fn imported(xml: &str) -> Imported {
    import(xml.as_bytes(), "file.xml", &Choice::default()).expect("an import")
}

#[test]
fn a_guess_stands_above_what_it_is_about() {
    let text = text(&trip(file("", &value("#x2000", "STRING(0)", 0, ""), "").as_bytes(), 1).expect("a trip"));
    let said = "# A guess: the type of 0x2000: `STRING(0)` of 0 bits is taken for STRING(1).\n0x2000 = ";
    assert!(text.contains(said), "{text}");
    // What is about no table alone stands at the head.
    let (head, _) = text.split_once("source  ").expect("a source");
    assert!(head.contains("# A guess: what tools save: "), "{text}");
}

#[test]
fn a_guess_is_a_comment_whatever_the_file_calls_things() {
    let odd = value("#x2000", "STRING\n[lints]\nx = 1 # \u{202E}", 0, "");
    let files = imported(&file("", &odd, "")).files;
    let text = &files["device.toml"];
    assert!(!text.lines().any(|line| line == "[lints]") && !text.contains('\u{202E}'), "{text}");
}

#[test]
fn the_modes_of_a_drive_are_those_that_it_announces() {
    let drive = |bits: &str, other: &str| {
        let with = |index: &str, bits: &str| {
            let supported = value(index, "UDINT", 32, "");
            supported.replace("<Flags>", &format!("<Info><DefaultData>{bits}</DefaultData></Info><Flags>"))
        };
        let words = ["#x6040", "#x6041", "#x6840", "#x6841"].map(|at| value(at, "UINT", 16, ""));
        file("", &(words.concat() + &with("#x6502", bits) + &with("#x6d02", other)), "")
    };
    // CiA 402: bits 0, 5 and 7 are pp, hm and csp; 16 and above are the manufacturer's.
    let said = text(&whole(&drive("A1000100", "A1000100")));
    assert!(said.contains("[modes]\n1 = {}\n6 = {}\n8 = {}\n\n"), "{said}");
    // A mode of one axis is none of the device.
    let said = text(&whole(&drive("A1000100", "80000000")));
    assert!(said.contains("[modes]\n8 = {}\n\n"), "{said}");
    assert!(!text(&whole(&drive("00000000", "00000000"))).contains("[modes]"));
}

/// The head of a BMP file of 16 by 14 points, with a byte behind it.
fn picture(last: u8) -> String {
    let head = "424D00000000000000000000000000000000100000000E000000";
    format!("<ImageData16x14>{head}{last:02x}</ImageData16x14>")
}

#[test]
fn a_picture_is_a_file_beside_the_description() {
    let trip = whole(&file("", "", &picture(0xA5)));
    let pictures = &trip.imported.pictures;
    assert_eq!(pictures.keys().collect::<Vec<_>>(), ["picture.bmp"]);
    assert_eq!(pictures["picture.bmp"].last(), Some(&0xA5));
    assert!(text(&trip).contains("image     = \"picture.bmp\""), "{}", text(&trip));
}

#[test]
fn what_is_no_picture_is_lost() {
    for bytes in ["00", "424D0", "", "not a number"] {
        let xml = file("", "", &format!("<ImageData16x14>{bytes}</ImageData16x14>"));
        let trip = trip(xml.as_bytes(), 1).expect("a round trip");
        assert!(trip.imported.pictures.is_empty() && trip.silent.is_empty(), "{bytes}: {:?}", trip.silent);
        assert_eq!(trip.imported.report.lost(), usize::from(!bytes.is_empty()), "{bytes}");
    }
}

#[test]
fn what_is_like_another_object_is_said_once() {
    let item = |subindex: u8, channel: u8| {
        let limit = if subindex == 5 { channel } else { 9 };
        format!(
            "<SubItem><Name>Gain {subindex}</Name><Info><DefaultData>{:02X}00</DefaultData><MaxValue>{limit}</MaxValue></Info>\
             </SubItem>",
            subindex * 2
        )
    };
    let member = |subindex: u8| {
        format!(
            "<SubItem><SubIdx>{subindex}</SubIdx><Name>Gain {subindex}</Name><Type>UINT</Type><BitSize>16</BitSize>\
             <BitOffs>{}</BitOffs><Flags><Access>rw</Access></Flags></SubItem>",
            u32::from(subindex) * 16
        )
    };
    let count = "<SubItem><SubIdx>0</SubIdx><Name>N</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>";
    let members: String = (1..=6).map(member).collect();
    let kind =
        format!("<DataTypes><DataType><Name>DTR</Name><BitSize>112</BitSize>{count}{members}</DataType>");
    let object = |channel: u8| {
        let items: String = (1..=6).map(|subindex| item(subindex, channel)).collect();
        format!(
            "<Object><Index>#x20{channel}0</Index><Name>Channel {channel}</Name><Type>DTR</Type><BitSize>112</BitSize>\
             <Info><SubItem><Name>N</Name></SubItem>{items}</Info></Object>\n"
        )
    };
    let objects = [object(1), object(2), object(3)].concat();
    let said = text(&whole(&file("", &objects, "").replacen("<DataTypes>", &kind, 1)));
    let like = "like = \"0x2010\", name = \"Channel 2\", entries = { 5 = { max = 2 } }";
    assert!(said.contains(like), "{said}");
}
