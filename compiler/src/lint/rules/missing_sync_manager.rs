use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Direction, Place, Role, Section};
use crate::source::Location;

rule! {
    /// Whatever master and device exchange lies in memory that a sync manager guards: mail in two, process data in one
    /// for each direction that has any. Without it a master finds neither address nor length, and does not exchange
    /// what the description promises.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers]
    /// outputs = { address = 0x1100 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers]
    /// inputs = { address = 0x1100, pdos = ["0x1A00"] }
    /// ```
    pub(super) static RULE = "missing-sync-manager", ProcessData, Warning,
        "a mailbox or process data has no sync manager";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for need in needs(device) {
        let missing = need.roles.iter().filter(|role| device.sync_manager(**role).is_none());
        let keys: Vec<String> = missing.map(|role| format!("`[sync-managers.{}]`", role.key())).collect();
        if !keys.is_empty() {
            let message = format!("{} without a sync manager", need.what);
            let diagnostic = Diagnostic::new(&RULE, message, need.at, "nothing carries it");
            report.push(need.subject, diagnostic.help(format!("add {}", keys.join(" and "))));
        }
    }
}

/// Something to be carried, with the roles of the sync managers that carry it.
struct Need {
    subject: Place,
    what: &'static str,
    at: Location,
    roles: &'static [Role],
}

fn needs(device: &Device) -> impl Iterator<Item = Need> {
    let mailbox = device.mailbox.as_ref().map(|mailbox| Need {
        subject: Place::from(Section::Mailbox),
        what: "there is a mailbox",
        at: mailbox.origin.header(),
        roles: &[Role::MailboxOut, Role::MailboxIn],
    });
    let pdos = |way, section: Section, what, roles: &'static [Role]| {
        device.pdos_of(way).next().map(|pdo| Need {
            subject: section.at(pdo.index),
            what,
            at: pdo.origin.header(),
            roles,
        })
    };
    let outputs = pdos(Direction::Rx, Section::RxPdos, "there are RxPDOs", &[Role::Outputs]);
    let inputs = pdos(Direction::Tx, Section::TxPdos, "there are TxPDOs", &[Role::Inputs]);
    [mailbox, outputs, inputs].into_iter().flatten()
}
