//! Texts in several languages, addresses of web pages, the current from the E-bus, and messages of the diagnosis history.

use devc::import::{Choice, NoteKind, import};

use super::round_trip::trip;

/// A device with texts in German (1031), Chinese (2052), in no language (0) and in one that nobody knows (4660).
const XML: &str = "<EtherCATInfo><Vendor><Id>#xE0F</Id><Name>Example</Name></Vendor><Descriptions><Devices>
<Device Physics=\"KK\"><Type ProductCode=\"#x1\" RevisionNo=\"#x2\">T-1</Type>
<Name LcId=\"1033\">Drive</Name><Name LcId=\"1031\">Antrieb</Name><Name LcId=\"2052\">驱动器</Name>
<URL LcId=\"1033\">https://example.com/en</URL><URL LcId=\"1031\">https://example.com/de</URL>
<Info><Electrical><EBusCurrent>120</EBusCurrent></Electrical></Info><GroupType>G</GroupType>
<Profile><Dictionary><DataTypes>
<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>
<DataType><Name>USINT</Name><BitSize>8</BitSize></DataType>
<DataType><Name>DT2001</Name><BitSize>32</BitSize>
<SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>
<SubItem><SubIdx>1</SubIdx><Name>Gain</Name><DisplayName LcId=\"1033\">Gain</DisplayName>
<DisplayName LcId=\"1031\">Verstärkung</DisplayName><Type>UINT</Type><BitSize>16</BitSize><BitOffs>16</BitOffs></SubItem></DataType>
<DataType><Name>DT0800EN16</Name><BaseType>UINT</BaseType><BitSize>16</BitSize>
<EnumInfo><Text LcId=\"1033\">Off</Text><Text LcId=\"1031\">Aus</Text><Enum>0</Enum></EnumInfo>
<EnumInfo><Text LcId=\"1033\">On</Text><Text LcId=\"1031\">Ein</Text><Enum>1</Enum></EnumInfo></DataType>
</DataTypes><Objects>
<Object><Index>#x2000</Index><Name LcId=\"1033\">Speed</Name><Name LcId=\"1031\">Drehzahl</Name><Type>DT0800EN16</Type>
<BitSize>16</BitSize><Flags><Access>rw</Access><PdoMapping>T</PdoMapping></Flags></Object>
<Object><Index>#x2001</Index><Name>Loop</Name><Type>DT2001</Type><BitSize>32</BitSize><Info>
<SubItem><Name>SubIndex 000</Name><Info><DefaultData>01</DefaultData></Info></SubItem>
<SubItem><Name>Gain</Name><Info/></SubItem></Info><Flags><Access>rw</Access></Flags></Object>
<Object><Index>#x10F3</Index><Name>Diagnosis history</Name><Type>UINT</Type><BitSize>16</BitSize></Object>
</Objects></Dictionary>
<DiagMessages><DiagMessage><TextId>#x8001</TextId><MessageText LcId=\"1033\">Axis %d is hot</MessageText>
<MessageText LcId=\"1031\">Achse %d ist warm</MessageText><Description LcId=\"1033\">The motor warms up.</Description>
<Flags><DiagClass>warning</DiagClass></Flags>
<CauseRemedy Idx=\"1\"><Remedy LcId=\"1033\">Move less.</Remedy></CauseRemedy></DiagMessage>
<DiagMessage><TextId>194</TextId><MessageText LcId=\"0\">Ready</MessageText></DiagMessage></DiagMessages></Profile>
<Sm DefaultSize=\"2\" StartAddress=\"#x1100\" ControlByte=\"#x20\" Enable=\"1\">Inputs</Sm>
<TxPdo Fixed=\"1\" Sm=\"0\"><Index>#x1A00</Index><Name LcId=\"1033\">Inputs</Name><Name LcId=\"1031\">Eingänge</Name>
<Entry><Index>#x2000</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><Name LcId=\"1033\">Speed</Name>
<Name LcId=\"1031\">Drehzahl</Name><DataType>UINT</DataType></Entry></TxPdo>
</Device></Devices></Descriptions></EtherCATInfo>";

#[test]
fn texts_are_kept_in_all_languages() {
    let trip = trip(XML.as_bytes(), 1).expect("a round trip");
    let text: String = trip.imported.files.values().map(String::as_str).collect();
    assert_eq!(trip.changed, [], "{text}");
    let lost = trip.imported.report.notes.iter().filter(|note| note.kind == NoteKind::Lost);
    assert_eq!(lost.map(|note| &note.what).collect::<Vec<_>>(), Vec::<&String>::new());
    for line in [
        "names        = { de = \"Antrieb\", zh = \"驱动器\" }",
        "ebus-current = 120",
        "urls         = { de = \"https://example.com/de\" }",
        "names   = { de = \"Eingänge\" }",
        "[diagnosis.0x00C2]\ntext = \"Ready\"",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    // What an entry of a PDO is called is said at the object.
    assert!(text.contains("entries = [\"speed\"]"), "{text}");
}

#[test]
fn a_language_that_nobody_knows_is_a_loss() {
    let xml = XML.replace("LcId=\"2052\"", "LcId=\"4660\"");
    let imported = import(xml.as_bytes(), "file.xml", &Choice::default()).expect("an import");
    let lost: Vec<_> =
        imported.report.notes.iter().map(|note| (note.what.as_str(), note.says.as_str())).collect();
    assert!(lost.contains(&("Device/Name", "驱动器")), "{lost:?}");
}

#[test]
fn what_is_the_same_in_another_language_is_said_once() {
    let xml = XML.replace("Antrieb", "Drive");
    let imported = import(xml.as_bytes(), "file.xml", &Choice::default()).expect("an import");
    assert!(imported.files["device.toml"].contains("names        = { zh = \"驱动器\" }"));
    assert_eq!(imported.report.lost(), 0);
}
