use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Object, Protocol, SdoAccess, Section};

rule! {
    /// What a mailbox can do belongs to one of its protocols: dictionary, assignment and mapping to CoE, the addresses of
    /// Ethernet to EoE. If the protocol is not among them, nothing can use it, and an ESI has no place for it. Nor can an object be
    /// transferred at once by a mailbox without complete access.
    ///
    /// ## Fires
    /// ```toml
    /// [mailbox]
    /// protocols = ["FoE"]
    /// pdo-assign = true
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [mailbox]
    /// protocols = ["FoE"]
    /// ```
    pub(crate) static RULE = "unspoken-ability", Output, Warning,
        "the mailbox can do what none of its protocols can";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(mailbox) = &device.mailbox else { return };
    let abilities = [
        ("sdo-info", mailbox.sdo_info, Protocol::Coe),
        ("pdo-assign", mailbox.pdo_assign, Protocol::Coe),
        ("pdo-config", mailbox.pdo_config, Protocol::Coe),
        ("complete-access", mailbox.complete_access, Protocol::Coe),
        ("segmented", mailbox.segmented, Protocol::Coe),
        ("pdo-upload", mailbox.pdo_upload == Some(true), Protocol::Coe),
        ("aoe-router", mailbox.aoe_router == Some(true), Protocol::Aoe),
        ("aoe-generates-net-id", mailbox.aoe_generates_net_id == Some(true), Protocol::Aoe),
        ("aoe-initialize-net-id", mailbox.aoe_initialize_net_id == Some(true), Protocol::Aoe),
        ("eoe-ip", mailbox.eoe_ip == Some(true), Protocol::Eoe),
        ("eoe-mac", mailbox.eoe_mac == Some(true), Protocol::Eoe),
    ];
    for (key, able, protocol) in abilities {
        if able && !mailbox.protocols.contains(&protocol) {
            let message = format!("`{key}` needs {}, which the mailbox does not speak", protocol.name());
            let diagnostic = Diagnostic::new(&RULE, message, mailbox.origin.value(key), "cannot be used")
                .label(mailbox.origin.value("protocols"), format!("no {}", protocol.name()));
            report.push(Section::Mailbox.at(key), diagnostic);
        }
    }
    let whole =
        |object: &&Object| object.sdo_access == Some(SdoAccess::Complete) && object.origin.has("sdo-access");
    for object in lookup::objects(device).filter(whole).filter(|_| !mailbox.complete_access) {
        let message = format!("{} is transferred at once, which the mailbox cannot do", object.index);
        let at = object.origin.value("sdo-access");
        let diagnostic = Diagnostic::new(&RULE, message, at, "cannot be done")
            .label(mailbox.origin.value("complete-access"), "without `complete-access = true`");
        report.push(object.index, diagnostic);
    }
}
