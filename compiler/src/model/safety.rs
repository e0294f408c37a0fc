//! What few values are: of weight to the safety of a machine, or transferred in one way only.

use super::table::part;

part! {
    /// What a value is to the safety of a machine.
    #[derive(Copy, Eq)]
    pub enum Safety {
        /// A safe input.
        Inputs,
        /// A safe output.
        Outputs,
        /// Both.
        InputsOutputs,
        /// A parameter that safety depends on.
        Parameters,
    }

    /// How the entries of an object are to be transferred.
    #[derive(Copy, Eq)]
    pub enum SdoAccess {
        /// All at once.
        Complete,
        /// Each by itself.
        Single,
    }
}

impl Safety {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Inputs, Self::Outputs, Self::InputsOutputs, Self::Parameters];

    /// Its name in an ESI file, ETG.2000.
    pub fn name(self) -> &'static str {
        match self {
            Self::Inputs => "si",
            Self::Outputs => "so",
            Self::InputsOutputs => "sio",
            Self::Parameters => "sp",
        }
    }

    /// The word for it in a description.
    pub fn word(self) -> &'static str {
        match self {
            Self::Inputs => "inputs",
            Self::Outputs => "outputs",
            Self::InputsOutputs => "inputs-outputs",
            Self::Parameters => "parameters",
        }
    }
}

impl SdoAccess {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Complete, Self::Single];

    /// Its name in an ESI file, ETG.2000.
    pub fn name(self) -> &'static str {
        match self {
            Self::Complete => "CompleteAccess",
            Self::Single => "SubIndexAccess",
        }
    }

    /// The word for it in a description.
    pub fn word(self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::Single => "single",
        }
    }
}
