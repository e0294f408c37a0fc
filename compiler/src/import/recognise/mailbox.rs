//! The mailbox, and how long a master waits for it and for the device.

use super::super::read::{Device, Mailbox, Timeout};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::draft::Block;

/// Where a device keeps its diagnosis messages: an ESI says so if the object is there.
const DIAGNOSIS_HISTORY: u16 = 0x10F3;

/// The protocols in the order that ETG.2000 demands of their elements, which says nothing.
const PROTOCOLS: [&str; 6] = ["AoE", "EoE", "CoE", "FoE", "SoE", "VoE"];

/// `[mailbox]`.
pub(super) fn mailbox(device: &Device, report: &mut Report) -> Option<Block> {
    let mailbox = device.mailbox.as_ref()?;
    if mailbox.protocols.is_empty() {
        report.lose(mailbox.at, 0, "Mailbox", "it has none of the protocols that descriptions know");
        return None;
    }
    if !mailbox.acknowledged {
        let why = "the file does not say that mail is acknowledged; it is taken to be";
        report.guess(mailbox.at, "DataLinkLayer", why);
    }
    let mut keys = Keys::new();
    let has = |protocol: &str| mailbox.protocols.iter().any(|it| it == protocol);
    let protocols = PROTOCOLS.into_iter().filter(|protocol| has(protocol));
    set(&mut keys, "protocols", Toml::texts(protocols));
    for (name, value) in abilities(mailbox).into_iter().filter(|_| has("CoE")) {
        if value {
            set(&mut keys, name, Toml::Bool(true));
        }
    }
    for (name, value) in &mailbox.others {
        set(&mut keys, name, Toml::Bool(*value));
    }
    if mailbox.diagnosis && device.objects.iter().all(|object| object.index != DIAGNOSIS_HISTORY) {
        report.lose(mailbox.at, 1, "CoE/@DiagHistory", "there is no object 0x10F3");
    }
    Some(Block::new("mailbox", None, keys))
}

fn abilities(mailbox: &Mailbox) -> [(&'static str, bool); 5] {
    [
        ("sdo-info", mailbox.sdo_info),
        ("pdo-assign", mailbox.pdo_assign),
        ("pdo-config", mailbox.pdo_config),
        ("complete-access", mailbox.complete_access),
        ("segmented", mailbox.segmented),
    ]
}

/// `[timeouts]`: those of the state machine, and those of the mailbox; an ESI has each kind as a whole.
pub(super) fn timeouts(timeouts: &[Timeout], report: &mut Report) -> Option<Block> {
    let is_mailbox = |timeout: &&Timeout| ["request", "response"].contains(&timeout.key);
    let (mailbox, states): (Vec<&Timeout>, Vec<&Timeout>) = timeouts.iter().partition(is_mailbox);
    let mut keys = Keys::new();
    for (kind, count) in [(states, 4), (mailbox, 2)] {
        for timeout in kind.iter().filter(|_| kind.len() < count) {
            report.lose(
                timeout.at,
                1,
                format!("the timeout {}", timeout.key),
                "others that belong to it are missing",
            );
        }
        for timeout in kind.iter().filter(|_| kind.len() == count) {
            set(&mut keys, timeout.key, Toml::text(time(timeout.milliseconds)));
        }
    }
    (!keys.is_empty()).then(|| Block::new("timeouts", None, keys))
}

/// In seconds where they are whole.
fn time(milliseconds: u32) -> String {
    match milliseconds {
        1.. if milliseconds.is_multiple_of(1000) => format!("{} s", milliseconds / 1000),
        _ => format!("{milliseconds} ms"),
    }
}
