use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, images};
use crate::model::{Device, Role, Section};

rule! {
    /// A sync manager that is shorter than what is assigned to it by default cuts off the last values; a mailbox
    /// below 16 bytes has no room for an SDO.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT64"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// max-size = 6
    /// pdos = ["0x1A00"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT64"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// max-size = 8
    /// pdos = ["0x1A00"]
    /// ```
    pub(super) static RULE = "undersized-sync-manager", ProcessData, Warning,
        "a sync manager is too short for what it carries";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for manager in &device.sync_managers {
        let key = &manager.id;
        let needs = match manager.role {
            Role::MailboxOut | Role::MailboxIn => MAILBOX,
            Role::Outputs | Role::Inputs => device.carried_bytes(manager),
        };
        let limits = [("size", Some(manager.size)), ("max-size", manager.max_size)];
        let short =
            limits.into_iter().find_map(|(key, bytes)| Some((key, bytes.filter(|b| u32::from(*b) < needs)?)));
        let Some((limit, bytes)) = short else { continue };
        let message = format!("`{key}` has {bytes} bytes, but needs {needs}");
        let at = manager.origin.value(limit);
        let diagnostic = Diagnostic::new(&RULE, message, at, format!("{bytes} bytes"));
        let diagnostic = match manager.origin.has("pdos") {
            true => diagnostic.label(manager.origin.value("pdos"), format!("{needs} bytes by default")),
            false => diagnostic.note("a mailbox has 6 bytes of head, 2 of CoE and 8 of an SDO at least"),
        };
        report.push(Section::SyncManagers.at(key), diagnostic);
    }
    chosen(device, report);
}

/// What configurations have a sync manager carry.
fn chosen(device: &Device, report: &mut Report) {
    for image in images::images(device).filter(|image| image.configuration.is_some()) {
        let (Some(manager), Some(assigned)) = (image.manager, image.assigned()) else { continue };
        let needs = image.bytes();
        let Some(max) = manager.max_size.filter(|max| u32::from(*max) < needs) else { continue };
        let message = format!("`{}` has {max} bytes, but needs {needs}", manager.role.key());
        let diagnostic = Diagnostic::new(&RULE, message, assigned, format!("{needs} bytes"));
        report
            .push(image.place(), diagnostic.label(manager.origin.value("max-size"), format!("{max} bytes")));
    }
}

/// What the shortest SDO takes: mailbox head, CoE head, SDO head with data.
const MAILBOX: u32 = 6 + 2 + 8;
