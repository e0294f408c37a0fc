//! When a value that is written takes effect, and how long it lasts.

use super::table::part;

part! {
    /// When a new value takes effect.
    #[derive(Copy, Eq)]
    pub enum Effective {
        /// When it is written.
        AtOnce,
        /// When the drive is not in Operation enabled: at once, or as soon as it leaves it.
        Disabled,
        /// On the next change from Pre-Operational to Safe-Operational.
        SafeOp,
        /// When the device has started anew.
        Restart,
    }

    /// Whether a device keeps a value when it is switched off.
    #[derive(Copy, Eq)]
    pub enum Stored {
        /// As soon as it is written.
        AtOnce,
        /// Once a master has asked for it, as by 0x1010.
        OnRequest,
        /// It is forgotten.
        Never,
    }
}

impl Effective {
    /// What that means, without a full stop.
    pub fn sentence(self) -> &'static str {
        match self {
            Self::AtOnce => "a new value takes effect at once",
            Self::Disabled => "a new value takes effect when the drive is not in Operation enabled",
            Self::SafeOp => {
                "a new value takes effect on the next change from Pre-Operational to Safe-Operational"
            }
            Self::Restart => "a new value takes effect when the device has started anew",
        }
    }
}

impl Stored {
    /// What that means, without a full stop.
    pub fn sentence(self) -> &'static str {
        match self {
            Self::AtOnce => "the device keeps it as soon as it is written",
            Self::OnRequest => "the device keeps it once it is asked to",
            Self::Never => "the device forgets it when it is switched off",
        }
    }
}
