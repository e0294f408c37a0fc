use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Place, Section};
use crate::source::Origin;

rule! {
    /// What is taken if nobody chooses is one: of two defaults a master takes the first, and the other is none.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-modes]
    /// free-run = { name = "Free run", assign-activate = 0, default = true }
    /// sm-sync = { name = "SM synchronous", assign-activate = 0, default = true }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-modes]
    /// free-run = { name = "Free run", assign-activate = 0, default = true }
    /// sm-sync = { name = "SM synchronous", assign-activate = 0 }
    /// ```
    pub(super) static RULE = "repeated-default", ProcessData, Warning,
        "two alternatives are the default";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let modes = device.sync_modes.iter().filter(|mode| mode.default);
    judge(modes.map(|mode| (Section::SyncModes.at(&mode.id), &mode.origin)), report);
    let configurations = device.configurations.iter().filter(|configuration| configuration.default);
    judge(configurations.map(|one| (Section::Configurations.at(&one.id), &one.origin)), report);
}

fn judge<'d>(mut defaults: impl Iterator<Item = (Place, &'d Origin)>, report: &mut Report) {
    let Some((first, origin)) = defaults.next() else { return };
    for (second, other) in defaults {
        let message = format!("both `{first}` and `{second}` are the default");
        let diagnostic = Diagnostic::new(&RULE, message, other.value("default"), "the default")
            .label(origin.value("default"), "also the default");
        report.push(second, diagnostic);
    }
}
