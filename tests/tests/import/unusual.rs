//! What files in use may have and hardly any has: prefixes, lists of files, several dictionaries, values at types, other
//! encodings.

use devc::import::{Choice, Imported, NoteKind, import};

use super::round_trip::trip;
use super::transport::{file, text, value, whole};

fn imported(xml: impl AsRef<[u8]>) -> Imported {
    import(xml.as_ref(), "file.xml", &Choice::default()).expect("an import")
}

fn plain() -> String {
    file("", &value("#x2000", "UINT", 16, ""), "")
}

fn description(imported: &Imported) -> String {
    imported.files.values().map(String::as_str).collect()
}

#[test]
fn elements_may_have_the_prefix_of_the_root() {
    let prefixed: String = plain()
        .split_inclusive('<')
        .map(|piece| piece.strip_suffix('<').map_or(piece.to_owned(), |text| format!("{text}<e:")))
        .collect::<String>()
        .replace("<e:/", "</e:")
        .replacen("<e:EtherCATInfo", "<e:EtherCATInfo xmlns:e=\"urn:e\"", 1);
    assert!(prefixed.contains("</e:Index>"));
    assert_eq!(description(&imported(&prefixed)), description(&imported(plain())));
    // What has another prefix is another vendor's.
    let other = plain().replace("<GroupType>G</GroupType>", "<o:GroupType xmlns:o=\"urn:o\">G</o:GroupType>");
    assert_eq!(imported(other).report.lost(), 1);
}

#[test]
fn a_list_of_files_has_the_devices_of_all() {
    let second = plain().replace("#xE0F", "#xE10").replace("T-1", "T-2").replace("Tee", "Two");
    let list = format!("<EtherCATInfoList>{}{second}</EtherCATInfoList>", plain());
    let choice = Choice { device: Some("T-2".to_owned()), revision: None };
    let chosen = import(list.as_bytes(), "file.xml", &choice).expect("an import");
    let text = description(&chosen);
    assert!(text.contains("vendor-id    = 0x00000E10") && text.contains("\"Two\""), "{text}");
    let refusal = import(b"<EtherCATInfoList/>", "file.xml", &Choice::default()).expect_err("a refusal");
    assert_eq!(refusal.why, "it has no device");
}

#[test]
fn each_profile_may_have_a_dictionary() {
    let other = value("#x3000", "USINT", 8, "");
    let second = format!(
        "</Profile><Profile><Dictionary><DataTypes><DataType><Name>USINT</Name><BitSize>8</BitSize></DataType></DataTypes>\
         <Objects>{other}</Objects></Dictionary></Profile>"
    );
    let text = text(&whole(&plain().replacen("</Profile>", &second, 1)));
    assert!(text.contains("0x2000 = ") && text.contains("0x3000 = "), "{text}");
}

#[test]
fn a_type_says_the_values_that_an_object_does_not() {
    let item = |subindex: u8, said: &str| {
        format!(
            "<SubItem><SubIdx>{subindex}</SubIdx><Name>M{subindex}</Name><Type>UINT</Type><BitSize>16</BitSize>\
             <BitOffs>16</BitOffs>{said}</SubItem>"
        )
    };
    let count = "<SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>";
    let limits = "<DefaultData>3412</DefaultData><MinValue>1</MinValue><MaxValue>#x7000</MaxValue>";
    let kind = format!(
        "<DataTypes><DataType><Name>DTR</Name><BitSize>48</BitSize>{count}{}{}</DataType>",
        item(1, limits),
        item(2, limits)
    );
    let object = "<Object><Index>#x2000</Index><Name>R</Name><Type>DTR</Type><BitSize>48</BitSize><Info>\
        <SubItem><Name>SubIndex 000</Name></SubItem><SubItem><Name>M1</Name><Info><DefaultData>0500</DefaultData></Info></SubItem>\
        </Info></Object>";
    let xml = file("", object, "").replacen("<DataTypes>", &kind, 1);
    let trip = trip(xml.as_bytes(), 1).expect("a round trip");
    let said = text(&trip);
    // 1 and 0x7000 are the limits of both, 0x1234 is the default of the second.
    let both = "min     = 1\nmax     = 28672\n";
    assert!(said.contains(both) && said.contains("default = 5") && said.contains("default = 4660"), "{said}");
    // The default that the object says otherwise is no more than a note.
    let lost = trip.imported.report.notes.iter().filter(|note| note.kind == NoteKind::Lost);
    assert_eq!(lost.map(|note| note.what.as_str()).collect::<Vec<_>>(), ["SubItem/DefaultData"]);
}

#[test]
fn what_may_be_read_wrongly_is_told() {
    let guesses = |xml: &[u8]| {
        let notes = imported(xml).report.notes.into_iter().filter(|note| note.kind == NoteKind::Guessed);
        notes.map(|note| note.what).filter(|what| what != "what tools save").collect::<Vec<_>>()
    };
    let entity = format!("<!DOCTYPE EtherCATInfo [<!ENTITY a \"b\">]>{}", plain().replace("Tee", "&a;"));
    assert_eq!(guesses(entity.as_bytes()), ["entities"]);
}

#[test]
fn configurations_of_one_name_have_words_of_their_own() {
    let choice = "<Info><VendorSpecific><TwinCAT><AlternativeSmMapping><Name>Start-up</Name><Sm No=\"0\"><Pdo>#x1600</Pdo></Sm>\
        </AlternativeSmMapping></TwinCAT></VendorSpecific></Info>";
    let after = "<Sm StartAddress=\"#x1000\" ControlByte=\"#x64\" Enable=\"1\">Outputs</Sm><RxPdo Fixed=\"1\" Sm=\"0\"><Index>#x1600\
        </Index><Name>P</Name><Entry><Index>0</Index><BitLen>8</BitLen></Entry></RxPdo><Mailbox><CoE><InitCmd>\
        <Transition>PS</Transition><Index>#x2000</Index><SubIndex>0</SubIndex><Data>0100</Data></InitCmd></CoE></Mailbox>";
    let xml = file(choice, &value("#x2000", "UINT", 16, ""), after);
    let text = text(&trip(xml.as_bytes(), 1).expect("a round trip"));
    assert!(
        text.contains("[configurations.start-up]\n") && text.contains("[configurations.start-up-2]\n"),
        "{text}"
    );
}

#[test]
fn what_is_in_another_file_is_said_to_be() {
    let xml = plain().replace("<Dictionary>", "<DictionaryFile>more.xml</DictionaryFile><Dictionary>");
    let note =
        imported(xml).report.notes.into_iter().find(|note| note.kind == NoteKind::Lost).expect("a loss");
    assert_eq!(
        (note.what.as_str(), note.why.as_str()),
        ("Profile/DictionaryFile", "it is in another file, and no other file is read")
    );
}

#[test]
fn entries_of_a_fixed_pdo_are_fixed() {
    let pdo = |fixed: u8, entry: u8| {
        let after = format!(
            "<Sm StartAddress=\"#x1000\" ControlByte=\"#x64\" Enable=\"1\">Outputs</Sm><RxPdo Fixed=\"{fixed}\" Sm=\"0\"><Index>#x1600\
             </Index><Name>P</Name><Entry Fixed=\"{entry}\"><Index>0</Index><BitLen>8</BitLen></Entry></RxPdo>"
        );
        let report = imported(file("", &value("#x2000", "UINT", 16, ""), &after)).report;
        report.lost()
    };
    assert_eq!([pdo(1, 1), pdo(0, 0), pdo(0, 1), pdo(1, 0)], [0, 0, 1, 1]);
}

#[test]
fn what_a_type_cannot_hold_is_quoted() {
    let object = value("#x2000", "UINT", 16, "");
    let object = object.replace("<Flags>", "<Info><DefaultValue>70000</DefaultValue></Info><Flags>");
    let notes = imported(file("", &object, "")).report.notes;
    let note = notes.into_iter().find(|note| note.kind == NoteKind::Lost).expect("a loss");
    assert_eq!(note.why, "`70000`, as UINT16: it does not fit its type");
}
