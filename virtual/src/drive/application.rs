//! What the firmware says to changes of the EtherCAT state.

use devc_runtime::esm;

/// Agrees to everything, and knows whether outputs have come.
#[derive(Debug, Clone, Copy)]
pub(super) struct Application {
    pub(super) has_outputs: bool,
}

impl esm::Application for Application {
    fn has_outputs(&self) -> bool {
        self.has_outputs
    }
}
