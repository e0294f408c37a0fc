use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Direction, Index};

rule! {
    /// ETG.1000.6 has 0x1600 to 0x17FF for what a device receives, and 0x1A00 to 0x1BFF for what it sends. Tools that tell
    /// the direction of a PDO by its index take one that lies elsewhere for what it is not.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1601]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A01]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    pub(super) static RULE = "misplaced-pdo", ProcessData, Error,
        "a PDO has an index that is not for its direction";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pdo in device.pdos.iter().filter(|pdo| !pdo.direction.indices().contains(&pdo.index.0)) {
        let what = match pdo.direction {
            Direction::Rx => "receive",
            Direction::Tx => "transmit",
        };
        let indices = pdo.direction.indices();
        let message = format!("{} is no index of a {what} PDO", pdo.index);
        let label = format!("these have {} to {}", Index(*indices.start()), Index(*indices.end()));
        report.push(pdo.index, Diagnostic::new(&RULE, message, pdo.origin.header(), label));
    }
}
