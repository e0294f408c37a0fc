//! `DiagMessages`: what the text ids of the diagnosis history say.

use super::element::Element;
use super::literal::{Hex, prose};
use crate::model::{Device, DiagnosisMessage};

/// The messages, if there are any.
pub(super) fn messages(device: &Device) -> Option<Element> {
    Element::new("DiagMessages").children(device.diagnosis.iter().map(message)).unless_empty()
}

fn message(message: &DiagnosisMessage) -> Element {
    let class = message.class.map(|class| Element::leaf("DiagClass", class.name()));
    let remedy = message.remedy.as_ref().map(|text| Element::worded("Remedy", prose(text)));
    Element::new("DiagMessage")
        .child(Element::leaf("TextId", Hex(message.text_id)))
        .children(Element::in_languages("MessageText", &message.text, &message.texts))
        .child(message.about.as_ref().map(|about| Element::worded("Description", prose(about))))
        .child(class.map(|class| Element::new("Flags").child(class)))
        .child(remedy.map(|remedy| Element::new("CauseRemedy").with("Idx", 1).child(remedy)))
}
