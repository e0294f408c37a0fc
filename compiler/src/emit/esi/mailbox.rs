//! `Mailbox`: the protocols beside process data.

use super::element::Element;
use crate::model::{Device, Index, Mailbox, Protocol};

/// Where a device keeps its diagnosis messages, if it keeps any.
const DIAGNOSIS_HISTORY: Index = Index(0x10F3);

/// The mailbox, if the device has one. The protocols stand in the order that the schema demands.
pub(super) fn mailbox(device: &Device) -> Option<Element> {
    let mailbox = device.mailbox.as_ref()?;
    let order = [Protocol::Eoe, Protocol::Coe, Protocol::Foe, Protocol::Soe, Protocol::Voe].into_iter();
    let spoken = order.filter(|protocol| mailbox.protocols.contains(protocol));
    let elements = spoken.map(|protocol| match protocol {
        Protocol::Coe => coe(device, mailbox),
        other => Element::new(other.name()),
    });
    Some(Element::new("Mailbox").with_flag("DataLinkLayer", true).children(elements))
}

fn coe(device: &Device, mailbox: &Mailbox) -> Element {
    Element::new("CoE")
        .with_flag("SdoInfo", mailbox.sdo_info)
        .with_flag("PdoAssign", mailbox.pdo_assign)
        .with_flag("PdoConfig", mailbox.pdo_config)
        .with_flag("CompleteAccess", mailbox.complete_access)
        .with_flag("SegmentedSdo", mailbox.segmented)
        .with_some("DiagHistory", device.object(DIAGNOSIS_HISTORY).map(|_| "1"))
}
