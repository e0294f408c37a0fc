use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section, SyncManager};

rule! {
    /// What a sync manager is for says what it can do (ETG.1000.6). Mail is exchanged from Pre-Operational on, and no PDO is
    /// assigned to it; outputs are what the master sends, inputs what the device sends. What is off carries nothing.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers.outputs]
    /// address = 0x1100
    /// pdos = ["0x1A00"]
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers.outputs]
    /// address = 0x1100
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    /// ```
    pub(super) static RULE = "contradicted-role", ProcessData, Warning,
        "a sync manager is to do what it is not for";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for manager in &device.sync_managers {
        let faults = if manager.role.is_process_data() {
            process_data(device, manager)
        } else {
            mail(device, manager)
        };
        for (key, fault) in faults.into_iter().filter(|(key, _)| manager.origin.has(key)) {
            let message = format!("`{}` {fault}", manager.id);
            let at = manager.origin.value(key);
            let role = if manager.origin.has("role") {
                manager.origin.value("role")
            } else {
                manager.origin.header()
            };
            let diagnostic = Diagnostic::new(&RULE, message, at, "does not go with what it is for");
            report.push(
                Section::SyncManagers.at(&manager.id).at(key),
                diagnostic.label(role, "what it is for"),
            );
        }
    }
}

fn mail(device: &Device, manager: &SyncManager) -> Vec<(&'static str, String)> {
    let is_off = device.mailbox.is_some() && !manager.enable && manager.size > 0;
    let facts = [
        ("pdos", !manager.pdos.is_empty(), "carries mail, but PDOs are assigned to it"),
        ("slots", manager.slots > 0, "carries mail, but has slots for PDOs"),
        ("enable", is_off, "is off, but there is a mailbox"),
        ("op-only", manager.op_only, "is on in Operational only, but mail comes from Pre-Operational on"),
        (
            "virtual",
            manager.r#virtual && device.mailbox.is_some(),
            "is not in the device, but there is a mailbox",
        ),
    ];
    facts.into_iter().filter(|(_, holds, _)| *holds).map(|(key, _, fault)| (key, fault.to_owned())).collect()
}

fn process_data(device: &Device, manager: &SyncManager) -> Vec<(&'static str, String)> {
    let mut pdos = manager.pdos.iter().filter_map(|pdo| device.pdo(*pdo));
    let strange = pdos.find(|pdo| crate::model::Role::of(pdo.direction) != manager.role);
    let strange = strange.map(|pdo| {
        let way = if manager.role.is_written() { "what the master sends" } else { "what the device sends" };
        ("pdos", format!("is for {way}, but {} goes the other way", pdo.index))
    });
    let bytes = device.carried_bytes(manager);
    let is_idle = !manager.enable && bytes > 0;
    let idle = is_idle.then(|| ("enable", format!("is off, but {bytes} bytes are assigned to it")));
    strange.into_iter().chain(idle).collect()
}
