//! `Mailbox`: the protocols beside process data.

use super::element::Element;
use super::literal::{Bytes, Hex};
use crate::model::{Device, Index, Mailbox, Protocol, SdoWrite};

/// Where a device keeps its diagnosis messages, if it keeps any.
const DIAGNOSIS_HISTORY: Index = Index(0x10F3);

/// The mailbox, if the device has one. The protocols stand in the order that the schema demands.
pub(super) fn mailbox(device: &Device) -> Option<Element> {
    let mailbox = device.mailbox.as_ref()?;
    let order = [Protocol::Aoe, Protocol::Eoe, Protocol::Coe, Protocol::Foe, Protocol::Soe, Protocol::Voe]
        .into_iter();
    let spoken = order.filter(|protocol| mailbox.protocols.contains(protocol));
    let elements = spoken.map(|protocol| match protocol {
        Protocol::Coe => coe(device, mailbox),
        Protocol::Aoe => aoe(mailbox),
        Protocol::Eoe => eoe(mailbox),
        other => Element::new(other.name()),
    });
    Some(Element::new("Mailbox").with_flag("DataLinkLayer", true).children(elements))
}

fn flag(value: Option<bool>) -> Option<u8> {
    value.map(u8::from)
}

fn aoe(mailbox: &Mailbox) -> Element {
    Element::new("AoE")
        .with_some("AdsRouter", flag(mailbox.aoe_router))
        .with_some("GenerateOwnNetId", flag(mailbox.aoe_generates_net_id))
        .with_some("InitializeOwnNetId", flag(mailbox.aoe_initialize_net_id))
}

fn eoe(mailbox: &Mailbox) -> Element {
    Element::new("EoE").with_some("IP", flag(mailbox.eoe_ip)).with_some("MAC", flag(mailbox.eoe_mac))
}

/// What a master writes at start-up for the configuration that the device is in by default. Assignment and mapping are
/// not among it: masters write them by themselves, as the PDOs say.
fn init_commands(device: &Device) -> impl Iterator<Item = Element> {
    let default = device.configurations.iter().filter(|configuration| configuration.default);
    let writes = default.flat_map(|configuration| &configuration.startup);
    writes.filter(|write| !write.address.index.is_derived()).map(init_command)
}

fn init_command(write: &SdoWrite) -> Element {
    Element::new("InitCmd")
        .child(Element::leaf("Transition", &write.transition))
        .child(Element::leaf("Index", Hex(write.address.index.0)))
        .child(Element::leaf("SubIndex", write.address.subindex))
        .child(Element::leaf("Data", Bytes(&write.data)))
        .child(Element::leaf("Comment", &write.comment))
}

fn coe(device: &Device, mailbox: &Mailbox) -> Element {
    Element::new("CoE")
        .with_flag("SdoInfo", mailbox.sdo_info)
        .with_flag("PdoAssign", mailbox.pdo_assign)
        .with_flag("PdoConfig", mailbox.pdo_config)
        .with_flag("CompleteAccess", mailbox.complete_access)
        .with_flag("SegmentedSdo", mailbox.segmented)
        .with_some("PdoUpload", flag(mailbox.pdo_upload))
        .with_some("DiagHistory", device.object(DIAGNOSIS_HISTORY).map(|_| "1"))
        .children(init_commands(device))
}
