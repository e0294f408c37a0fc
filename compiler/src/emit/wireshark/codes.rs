//! AL status codes: those of the device, and of the others what the standard says.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::emit::escape::prose;
use crate::emit::program::Program;
use crate::profiles;
use crate::source::{CanonicalKey, Value};

/// A code with what it is called.
#[derive(Debug, Serialize)]
pub(super) struct Code {
    code: i64,
    title: String,
}

/// All that are known, by number.
pub(super) fn al_codes(program: &Program) -> Vec<Code> {
    let mut names = standard().unwrap_or_default();
    names.extend(program.al_codes.iter().map(|code| (code.code, code.title.clone())));
    names.into_iter().map(|(code, title)| Code { code, title }).collect()
}

/// Those that the profile has.
fn standard() -> Option<BTreeMap<i64, String>> {
    let profile = profiles::tree("ethercat")?;
    let codes = profile.get("al-status-codes")?.node.table()?;
    let named = codes.members.iter().filter_map(|member| {
        let CanonicalKey::Range(code, _) = member.key.canonical else { return None };
        let Value::String(name) = &member.node.table()?.get("name")?.node.value else { return None };
        Some((code, prose(name)))
    });
    Some(named.collect())
}
