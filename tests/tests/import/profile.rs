//! What a profile says of a device and of its channels, units of values, and mapping units of sync units.

use devc::import::NoteKind;

use super::round_trip::{Trip, trip};
use super::transport::{file, text, value, whole};

/// A drive with so many axes, whose profile begins so.
fn drive(axes: u16, profile: &str) -> String {
    let words = |axis: u16| {
        let at = |index: u16| format!("#x{:04x}", index + axis * 0x800);
        let word = |index| value(&at(index), "UINT", 16, "<PdoMapping>RT</PdoMapping>");
        word(0x6040) + &word(0x6041)
    };
    let kind = "<Object><Index>#x1000</Index><Name>Device type</Name><Type>UDINT</Type><BitSize>32</BitSize>\
        <Info><DefaultData>9201FFFF</DefaultData></Info><Flags><Access>ro</Access></Flags></Object>\n";
    let objects: String = std::iter::once(kind.to_owned()).chain((0..axes).map(words)).collect();
    file("", &objects, "").replace("<Profile>", &format!("<Profile><ProfileNo>402</ProfileNo>\n{profile}\n"))
}

fn channel(info: u32, name: &str) -> String {
    format!("<ChannelInfo><ProfileNo>402</ProfileNo><AddInfo>{info}</AddInfo>{name}</ChannelInfo>\n")
}

fn named(name: &str) -> String {
    format!("<DisplayName LcId=\"1033\">{name}</DisplayName>")
}

fn lost(trip: &Trip) -> Vec<&str> {
    let lost = trip.imported.report.notes.iter().filter(|note| note.kind == NoteKind::Lost);
    lost.map(|note| note.what.as_str()).collect()
}

#[test]
fn channels_are_axes_with_their_names_and_kind() {
    let channels = channel(2, &named("Left")) + &channel(2, &named("Right"));
    let text = text(&whole(&drive(2, &format!("<AddInfo>65535</AddInfo>{channels}"))));
    assert!(text.contains("names    = [\"Left\", \"Right\"]") && text.contains("add-info = 2"), "{text}");
}

#[test]
fn as_many_channels_as_axes_say_nothing_more() {
    whole(&drive(3, "<ChannelCount>3</ChannelCount>"));
    whole(&drive(1, "<ChannelCount>1</ChannelCount>"));
    let trip = trip(drive(2, "<ChannelCount>1</ChannelCount>").as_bytes(), 1).expect("a round trip");
    assert_eq!(lost(&trip), ["Profile/ChannelCount"]);
}

#[test]
fn channels_that_are_no_axes_are_lost() {
    let trip = trip(drive(2, &channel(4, &named("Brake"))).as_bytes(), 1).expect("a round trip");
    assert_eq!(lost(&trip), ["ChannelInfo/DisplayName", "ChannelInfo/AddInfo"]);
    assert_eq!(trip.imported.report.lost(), 2);
}

#[test]
fn units_are_those_of_their_codes() {
    let with = |index: &str, code: &str| {
        let value = value(index, "UDINT", 32, "<PdoMapping>T</PdoMapping>");
        value.replace("<Flags>", &format!("<Info><Unit>{code}</Unit></Info><Flags>"))
    };
    let objects = [
        with("#x2000", "#xfd040000"),
        with("#x2001", "#xFC260000"),
        with("#x2002", "#x03010000"),
        with("#x2003", "#x00b44700"),
    ];
    let said = text(&whole(&file("", &objects.concat(), "")));
    for unit in [
        "quantity = \"current\"\nsymbol   = \"mA\"\n",
        "quantity     = \"voltage\"\nsymbol       = \"V\"\nraw-per-unit = 10000\n",
        "quantity     = \"length\"\nsymbol       = \"m\"\nraw-per-unit = \"1/1000\"\n",
        "quantity = \"rotational speed\"\nsymbol   = \"rpm\"\n",
    ] {
        assert!(said.contains(unit), "{unit}: {said}");
    }
    assert!(said.contains("unit = \"current\"") && said.contains("unit = \"rotational-speed\""), "{said}");
    // Degrees Celsius are none of the units that descriptions know.
    let trip = trip(file("", &with("#x2000", "#xff2d0000"), "").as_bytes(), 1).expect("a round trip");
    assert_eq!(lost(&trip), ["Info/Unit"]);
    assert_eq!(trip.silent, Vec::<String>::new());
}

#[test]
fn a_mapping_unit_is_of_the_sync_unit_of_its_pdos() {
    let carried = |fmmu: u8| {
        format!(
            "<Fmmu Su=\"{fmmu}\">Outputs</Fmmu>\n<Sm DefaultSize=\"2\" StartAddress=\"#x1000\" ControlByte=\"#x64\" Enable=\"1\">\
             Outputs</Sm>\n<Su>Fast</Su><RxPdo Fixed=\"1\" Sm=\"0\" Su=\"0\"><Index>#x1600</Index><Name>P</Name><Entry><Index>\
             #x2000</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><Name>Value #x2000</Name><DataType>UINT</DataType></Entry>\
             </RxPdo>"
        )
    };
    let object = value("#x2000", "UINT", 16, "<PdoMapping>R</PdoMapping>");
    whole(&file("", &object, &carried(0)));
    let trip = trip(file("", &object, &carried(1)).as_bytes(), 1).expect("a round trip");
    assert_eq!((lost(&trip), trip.silent.len()), (vec!["Fmmu/@Su"], 0));
}
