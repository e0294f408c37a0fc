use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Configuration, Device, Index, Pdo, Role, Section};

rule! {
    /// The default configuration is what a master brings about that is told nothing else, and an ESI shows the PDOs as they
    /// are then. So it assigns what the sync managers have by default, and maps what the PDOs carry.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Values", entries = ["0x2000"] }
    /// 0x1A01 = { name = "Other values", entries = ["0x2000"] }
    ///
    /// [sync-managers]
    /// inputs = { address = 0x1100, pdos = ["0x1A00"] }
    ///
    /// [configurations.usual]
    /// name = "Usual"
    /// default = true
    /// inputs = ["0x1A01"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Values", entries = ["0x2000"] }
    /// 0x1A01 = { name = "Other values", entries = ["0x2000"] }
    ///
    /// [sync-managers]
    /// inputs = { address = 0x1100, pdos = ["0x1A01"] }
    ///
    /// [configurations.usual]
    /// name = "Usual"
    /// default = true
    /// inputs = ["0x1A01"]
    /// ```
    pub(super) static RULE = "contradicted-assignment", ProcessData, Warning,
        "the default configuration is not what the sync managers and PDOs have by default";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for configuration in device.configurations.iter().filter(|configuration| configuration.default) {
        let ways = [
            (Role::Outputs, "outputs", &configuration.outputs),
            (Role::Inputs, "inputs", &configuration.inputs),
        ];
        let assigned = ways.into_iter().filter_map(|(role, key, chosen)| {
            Some((key, judge_assigned(device, configuration, role, key, chosen.as_deref()?)?))
        });
        let mapped = configuration
            .mapping
            .iter()
            .filter_map(|pdo| Some(("mapping", judge_mapped(configuration, device.pdo(pdo.index)?, pdo)?)));
        for (key, diagnostic) in assigned.chain(mapped) {
            report.push(Section::Configurations.at(&configuration.id).at(key), diagnostic);
        }
    }
}

fn judge_assigned(
    device: &Device,
    configuration: &Configuration,
    role: Role,
    key: &str,
    chosen: &[Index],
) -> Option<Diagnostic> {
    let usual: Vec<Index> = device.assigned(role).map(|pdo| pdo.index).collect();
    // what another sync manager carries has no place before or behind
    let carrier = |pdo: &Index| device.sync_managers_of(role).position(|manager| manager.pdos.contains(pdo));
    let mut placed = chosen.to_vec();
    placed.sort_by_key(|pdo| carrier(pdo).unwrap_or_default());
    let shown = |pdos: &[Index]| if pdos.is_empty() { "none".to_owned() } else { lookup::list(pdos) };
    (usual != placed).then(|| {
        let message = format!(
            "the default configuration assigns {}, the sync manager {}",
            shown(chosen),
            shown(&usual)
        );
        let diagnostic = Diagnostic::new(&RULE, message, configuration.origin.value(key), "assigned here");
        match device.sync_manager(role) {
            Some(manager) => diagnostic.label(manager.origin.value("pdos"), "assigned by default"),
            None => diagnostic,
        }
    })
}

fn judge_mapped(configuration: &Configuration, usual: &Pdo, chosen: &Pdo) -> Option<Diagnostic> {
    let carried = |pdo: &Pdo| pdo.entries.iter().map(|entry| (entry.address, entry.bits)).collect::<Vec<_>>();
    (carried(usual) != carried(chosen)).then(|| {
        let message = format!("the default configuration maps {} anew", chosen.index);
        let at = configuration.origin.value("mapping");
        Diagnostic::new(&RULE, message, at, "mapped here")
            .label(usual.origin.value("entries"), "carried by default")
            .help("let the PDO carry this by default, or leave it out")
    })
}
