//! What an answer of the mailbox says about what the master did.

use devc_runtime::coe::{Envelope, MailboxError, Protocol, Response, Service};

use crate::event::Event;

/// The complaint that an answer is, if it is one.
pub(crate) fn complaint(answer: &[u8]) -> Option<Event> {
    if let [_, _, _, _, _, kind, _, _, low, high, ..] = *answer
        && kind & 0x0F == Protocol::ERROR.0
    {
        return Some(Event::MailRefused { error: MailboxError(u16::from_le_bytes([low, high])) });
    }
    if let [_, _, _, _, _, kind, 5, _, a, b, c, d, ..] = *answer
        && kind & 0x0F == Protocol::FOE.0
    {
        return Some(Event::FileRefused { code: u32::from_le_bytes([a, b, c, d]) });
    }
    let (envelope, body) = Envelope::open(answer).ok()?;
    let is_sdo = matches!(envelope.service, Service::SDO_REQUEST | Service::SDO_RESPONSE);
    match Response::decode(body) {
        Ok(Response::Abort { address, code }) if is_sdo => Some(Event::SdoAborted { address, code }),
        _ => None,
    }
}
