use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Role, Section};

rule! {
    /// A device has one mailbox for each direction (ETG.1000.4). Masters take the first of a role and leave another
    /// alone; what is sent there is never read.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// more = { role = "mailbox-out", address = 0x1080, size = 128 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    /// ```
    pub(super) static RULE = "repeated-mailbox", ProcessData, Warning,
        "two sync managers are mailboxes of one direction";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for role in [Role::MailboxOut, Role::MailboxIn] {
        let mut managers = device.sync_managers_of(role);
        let Some(first) = managers.next() else { continue };
        for second in managers {
            let message = format!("`{}` and `{}` are both `{}`", first.id, second.id, role.key());
            let diagnostic = Diagnostic::new(&RULE, message, second.origin.header(), "one too many")
                .label(first.origin.header(), "this one is there already")
                .help("leave one of them out, or give it the role that it has");
            report.push(Section::SyncManagers.at(&second.id), diagnostic);
        }
    }
}
