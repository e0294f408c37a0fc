//! What few devices say: each is in the description, and in the ESI that is made of it, as it was.

use super::round_trip::compiled;
use super::transport::{file, text, value, whole};

/// The values of an object, with what flags it has beside its access.
fn flagged(flags: &str) -> String {
    file("", &value("#x2000", "UINT", 16, flags), "")
}

fn esi(xml: &str) -> String {
    let trip = whole(xml);
    compiled(&trip.imported).expect("an ESI").0
}

#[test]
fn flags_of_safety_and_of_transfer_are_kept() {
    for (written, word) in
        [("si", "inputs"), ("so", "outputs"), ("sio", "inputs-outputs"), ("SP", "parameters")]
    {
        let xml = flagged(&format!("<SafetyMapping>{written}</SafetyMapping>"));
        assert!(text(&whole(&xml)).contains(&format!("safety = \"{word}\"")), "{written}");
        assert!(esi(&xml).contains(&format!("<SafetyMapping>{}<", written.to_lowercase())), "{written}");
    }
    for written in ["CompleteAccess", "SubIndexAccess"] {
        assert!(esi(&flagged(&format!("<SdoAccess>{written}</SdoAccess>"))).contains(written));
    }
}

#[test]
fn what_a_master_compares_is_kept() {
    // The values of ETG.2000.
    for revision in ["NONE", "EQ", "EQ_OR_G", "LW_EQ", "LW_EQ_HW_EQ_OR_G", "HW_EQ", "HW_EQ_LW_EQ_OR_G"] {
        let said = format!("CheckProductCode=\"EQ\" CheckRevisionNo=\"{revision}\"");
        let xml = file("", "", "").replace("RevisionNo=\"#x2\"", &format!("RevisionNo=\"#x2\" {said}"));
        assert!(esi(&xml).contains(&said), "{revision}");
    }
}

/// A PDO with one entry of 16 bits.
fn pdo(tag: &str, attributes: &str, index: &str, data_type: &str) -> String {
    format!(
        "<{tag} Fixed=\"1\" {attributes}><Index>{index}</Index><Name>P</Name><Entry><Index>#x2000</Index><SubIndex>0</SubIndex>\
         <BitLen>16</BitLen><Name>Value #x2000</Name><Comment>As it was measured</Comment><DataType>{data_type}</DataType>\
         </Entry></{tag}>"
    )
}

#[test]
fn what_a_pdo_says_beside_its_entries_is_kept() {
    let attributes = "Virtual=\"1\" OSFac=\"10\" OSMin=\"1\" OSMax=\"100\" OSIndexInc=\"8\"";
    let mappable = value("#x2000", "UINT", 16, "<PdoMapping>T</PdoMapping>");
    let made = esi(&file("", &mappable, &pdo("TxPdo", attributes, "#x1A00", "INT")));
    for said in [attributes, "<Comment>As it was measured</Comment>", "<DataType>INT</DataType>"] {
        assert!(made.contains(said), "{said}: {made}");
    }
}

#[test]
fn a_pdo_may_lie_where_those_of_the_other_direction_do() {
    let both = value("#x2000", "UINT", 16, "<PdoMapping>RT</PdoMapping>");
    let pdos = [pdo("RxPdo", "", "#x1A00", "UINT"), pdo("TxPdo", "", "#x1600", "UINT")].concat();
    let trip = whole(&file("", &both, &pdos));
    assert!(text(&trip).contains("misplaced-pdo = \"warn\""), "{}", text(&trip));
}

#[test]
fn what_ads_needs_is_kept() {
    let said = "<AoE AdsRouter=\"0\" GenerateOwnNetId=\"1\" InitializeOwnNetId=\"0\"/>";
    let mailbox = format!("<Mailbox DataLinkLayer=\"1\">{said}<CoE PdoUpload=\"1\"/></Mailbox>");
    let made = esi(&file("", "", &mailbox));
    assert!(made.contains(said) && made.contains("PdoUpload=\"1\""), "{made}");
}

#[test]
fn slots_whose_modules_are_to_be_chosen_are_kept() {
    let slots = "<Slots SlotPdoIncrement=\"1\" SlotIndexIncrement=\"#x10\"><Slot MinInstances=\"0\" MaxInstances=\"64\">\
        <Name>Terminals</Name><ModuleIdent Default=\"1\">#x1201</ModuleIdent><ModuleIdent>#x1202</ModuleIdent></Slot>\
        <Slot MinInstances=\"1\" MaxInstances=\"1\" SlotIndexIncrement=\"#x40\"><Name>Head</Name><ModuleClass>\
        <Class>head</Class><Name>Heads</Name></ModuleClass></Slot></Slots>";
    let made = esi(&file("", "", slots));
    let bare: String = made.lines().map(str::trim).collect();
    let bare = bare.replace(" LcId=\"1033\"", "");
    let said =
        [("#x1201", "#x00001201"), ("#x1202", "#x00001202"), ("#x10\"", "#x0010\""), ("#x40", "#x0040")];
    let slots = said.into_iter().fold(slots.to_owned(), |slots, (short, long)| slots.replace(short, long));
    assert!(bare.contains(&slots), "{made}");
}
