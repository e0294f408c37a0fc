//! `Info`: the current from the E-bus, how long a master waits, and how it finds the number that people set.

use super::choices::choices;
use super::element::Element;
use super::literal::Hex;
use crate::model::{Device, Duration, Timeouts};

/// What is said of it; no timeouts of a kind unless all of it are said, for the schema has no room for less.
pub(super) fn info(device: &Device) -> Option<Element> {
    let current = device.ebus_current.map(|current| Element::leaf("EBusCurrent", current));
    let states = device.timeouts.as_ref().and_then(state_machine);
    let mailbox = device.timeouts.as_ref().and_then(mailbox);
    Element::new("Info")
        .child(current.map(|current| Element::new("Electrical").child(current)))
        .child(states.map(|timeout| Element::new("StateMachine").child(timeout)))
        .child(mailbox.map(|timeout| Element::new("Mailbox").child(timeout)))
        .child(choices(device))
        .child(device.identity.id_address.map(|address| Element::leaf("IdentificationAdo", Hex(address))))
        .child(device.identity.requested_id.then(|| Element::leaf("IdentificationReg134", "true")))
        .unless_empty()
}

fn state_machine(timeouts: &Timeouts) -> Option<Element> {
    let timeout = Element::new("Timeout")
        .child(Element::leaf("PreopTimeout", milliseconds(timeouts.pre_op)?))
        .child(Element::leaf("SafeopOpTimeout", milliseconds(timeouts.safe_op_op)?))
        .child(Element::leaf("BackToInitTimeout", milliseconds(timeouts.back_to_init)?))
        .child(Element::leaf("BackToSafeopTimeout", milliseconds(timeouts.back_to_safe_op)?));
    Some(timeout)
}

fn mailbox(timeouts: &Timeouts) -> Option<Element> {
    let timeout = Element::new("Timeout")
        .child(Element::leaf("RequestTimeout", milliseconds(timeouts.request)?))
        .child(Element::leaf("ResponseTimeout", milliseconds(timeouts.response)?));
    Some(timeout)
}

fn milliseconds(time: Option<Duration>) -> Option<u64> {
    time.map(|time| time.0.div_ceil(1_000_000))
}
