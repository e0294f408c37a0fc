//! What the firmware says to changes of the EtherCAT state.

use devc_runtime::esm::{self, AlState, AlStatusCode, Change};

/// Knows whether outputs have come, and whether the clocks are set as the device needs them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Application {
    pub(super) has_outputs: bool,
    pub(super) clocks: Result<(), AlStatusCode>,
    /// Whether signals that a master has activated never come.
    pub(super) are_signals_missed: bool,
}

impl esm::Application for Application {
    fn before(&mut self, change: Change) -> Result<(), AlStatusCode> {
        match (change.from, change.to) {
            (AlState::PreOperational, AlState::SafeOperational) => self.clocks,
            (_, AlState::Operational) if self.are_signals_missed => Err(AlStatusCode::NO_SYNC_SIGNAL),
            (_, AlState::Operational) => self.clocks,
            _ => Ok(()),
        }
    }

    fn has_outputs(&self) -> bool {
        self.has_outputs
    }
}
