//! Error codes.

use super::context::Context;
use super::ids::Siblings;
use super::{facts, keys, values};
use crate::model::{ErrorCode, VendorCode};
use crate::raw::{Entity, RawError, RawVendorCode};

/// The error codes and ranges of them, by code, a range before what is in it.
pub(super) fn errors(context: &mut Context<'_>, raw: Vec<Entity<RawError>>) -> Vec<ErrorCode> {
    let mut errors = Vec::new();
    let mut ids = Siblings::default();
    for Entity { key, origin, raw, facts } in raw {
        let Some(range) = keys::range::<u16>(&key) else {
            context.invalid(&key, "an error code such as 0x7121, or a range of them", origin.header());
            continue;
        };
        errors.push(ErrorCode {
            code: *range.start(),
            last: *range.end(),
            id: ids.claim(&raw.name),
            name: raw.name,
            register: raw.register,
            vendor_codes: raw.vendor_codes,
            about: raw.about,
            remedy: raw.remedy,
            source: facts::source(context, &facts),
            origin,
        });
    }
    errors.sort_by_key(|error| (error.code, std::cmp::Reverse(error.last)));
    errors
}

/// The vendor's own codes, by code.
pub(super) fn vendor_codes(context: &mut Context<'_>, raw: Vec<Entity<RawVendorCode>>) -> Vec<VendorCode> {
    let mut codes = Vec::new();
    for Entity { key, origin, raw, facts } in raw {
        match keys::number(&key).and_then(|code| u32::try_from(code).ok()) {
            None => context.invalid(&key, "a code of the vendor's system", origin.header()),
            Some(code) => codes.push(VendorCode {
                code,
                name: raw.name,
                about: raw.about,
                causes: values::meanings(context, &raw.causes, &origin, "causes"),
                source: facts::source(context, &facts),
                origin,
            }),
        }
    }
    codes.sort_by_key(|code| code.code);
    codes
}
