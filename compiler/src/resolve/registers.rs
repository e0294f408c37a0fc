//! What lies in the EtherCAT slave controller and in its mailboxes.

use super::context::Context;
use super::{facts, keys, words};
use crate::model::{AlStatusCode, Register, RegisterAccess, Telegram};
use crate::raw::{Entity, RawAlStatusCode, RawRegister, RawRegisterAccess, RawTelegram};

/// The registers, by address.
pub(super) fn registers(context: &mut Context<'_>, raw: Vec<Entity<RawRegister>>) -> Vec<Register> {
    let mut registers = Vec::new();
    for Entity { key, origin, raw, facts } in raw {
        let Some(address) = keys::number(&key).and_then(|address| u16::try_from(address).ok()) else {
            context.invalid(&key, "the address of a register such as 0x0120", origin.header());
            continue;
        };
        registers.push(Register {
            address,
            length: raw.length,
            name: raw.name,
            ecat: access(raw.ecat),
            drive: access(raw.drive),
            fields: words::fields(context, &raw.bits, &origin, "bits"),
            about: raw.about,
            source: facts::source(context, &facts),
            origin,
        });
    }
    registers.sort_by_key(|register| register.address);
    registers
}

fn access(raw: RawRegisterAccess) -> RegisterAccess {
    match raw {
        RawRegisterAccess::None => RegisterAccess::None,
        RawRegisterAccess::R => RegisterAccess::R,
        RawRegisterAccess::W => RegisterAccess::W,
        RawRegisterAccess::Rw => RegisterAccess::Rw,
    }
}

/// The AL status codes, by code.
pub(super) fn al_status_codes(
    context: &mut Context<'_>,
    raw: Vec<Entity<RawAlStatusCode>>,
) -> Vec<AlStatusCode> {
    let mut codes = Vec::new();
    for Entity { key, origin, raw, facts } in raw {
        match keys::number(&key).and_then(|code| u16::try_from(code).ok()) {
            None => context.invalid(&key, "an AL status code such as 0x0011", origin.header()),
            Some(code) => codes.push(AlStatusCode {
                code,
                name: raw.name,
                during: raw.during,
                results: raw.results,
                about: raw.about,
                source: facts::source(context, &facts),
            }),
        }
    }
    codes.sort_by_key(|code| code.code);
    codes
}

/// The messages, in the order in which they were written.
pub(super) fn telegrams(context: &mut Context<'_>, raw: Vec<Entity<RawTelegram>>) -> Vec<Telegram> {
    raw.into_iter()
        .map(|Entity { key, origin, raw, facts }| Telegram {
            id: key,
            name: raw.name,
            address: raw.address,
            fields: words::fields(context, &raw.bytes, &origin, "bytes"),
            about: raw.about,
            source: facts::source(context, &facts),
            origin,
        })
        .collect()
}
