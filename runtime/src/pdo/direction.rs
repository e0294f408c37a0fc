//! Which way process data goes.

mod sealed {
    pub trait Sealed {}
}

/// Which way process data goes, seen from the device.
pub trait Direction: sealed::Sealed {
    /// The object whose subindices name the PDOs in use: that of sync manager 2 or 3 (ETG.1000.6).
    const ASSIGNMENT: u16;
}

/// Received by the device: the outputs of the master.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rx {}

/// Transmitted by the device: the inputs of the master.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tx {}

impl sealed::Sealed for Rx {}
impl sealed::Sealed for Tx {}

impl Direction for Rx {
    const ASSIGNMENT: u16 = 0x1C12;
}

impl Direction for Tx {
    const ASSIGNMENT: u16 = 0x1C13;
}
