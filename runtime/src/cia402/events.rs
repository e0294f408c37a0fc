//! What happens in a drive besides its commands.

use core::fmt;

/// What holds in the drive in this cycle, apart from the controlword: levels, not edges, so that none can be missed.
///
/// | constant | holds while | in CiA 402 |
/// |---|---|---|
/// | [`INITIALISED`](Self::INITIALISED) | start-up and self-test are over | transition 1 |
/// | [`FAULT`](Self::FAULT) | the cause of a fault is there | transition 13, and 15 waits for its end |
/// | [`FAULT_REACTION_OVER`](Self::FAULT_REACTION_OVER) | the drive has ended its reaction to a fault | transition 14 |
/// | [`QUICK_STOP_OVER`](Self::QUICK_STOP_OVER) | the drive has come to rest and its quick stop option code 0x605A is 1 to 3 | transition 12 |
/// | [`LOCKED_OUT`](Self::LOCKED_OUT) | something outside forbids power: no supply, safe torque off | transitions 7, 9, 10, 12 |
/// | [`NOT_ENABLED`](Self::NOT_ENABLED) | an additional enable signal is not given | Pilz 1005347, 6.5.2.3 |
///
/// ```
/// use devc_runtime::cia402::Events;
///
/// let now = Events::INITIALISED | Events::LOCKED_OUT;
/// assert!(now.any(Events::LOCKED_OUT | Events::FAULT));
/// assert_eq!(now.to_string(), "initialised, locked out");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Events(u8);

impl Events {
    /// Nothing.
    pub const NONE: Self = Self(0);
    /// Start-up and self-test are over (CiA 402, transitions 0 and 1).
    pub const INITIALISED: Self = Self(1);
    /// The cause of a fault is there (CiA 402, transition 13).
    pub const FAULT: Self = Self(1 << 1);
    /// The reaction to a fault is over (CiA 402, transition 14).
    pub const FAULT_REACTION_OVER: Self = Self(1 << 2);
    /// The quick stop is over, and the drive does not stay in quick stop active (CiA 402, transition 12).
    pub const QUICK_STOP_OVER: Self = Self(1 << 3);
    /// Power is forbidden from outside.
    pub const LOCKED_OUT: Self = Self(1 << 4);
    /// The additional enable signal is missing.
    pub const NOT_ENABLED: Self = Self(1 << 5);

    const NAMES: [(Self, &'static str); 6] = [
        (Self::INITIALISED, "initialised"),
        (Self::FAULT, "fault"),
        (Self::FAULT_REACTION_OVER, "fault reaction over"),
        (Self::QUICK_STOP_OVER, "quick stop over"),
        (Self::LOCKED_OUT, "locked out"),
        (Self::NOT_ENABLED, "not enabled"),
    ];

    /// These and `others`; as `|`, for constants.
    #[must_use]
    pub const fn and(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Those that are in both.
    #[must_use]
    pub const fn common(self, others: Self) -> Self {
        Self(self.0 & others.0)
    }

    /// Whether one of `others` is here.
    pub const fn any(self, others: Self) -> bool {
        self.0 & others.0 != 0
    }

    /// Whether there is none.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }
}

impl core::ops::BitOr for Events {
    type Output = Self;

    fn bitor(self, others: Self) -> Self {
        self.and(others)
    }
}

impl fmt::Display for Events {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut between = "";
        for (_, name) in Self::NAMES.iter().filter(|(event, _)| self.any(*event)) {
            write!(f, "{between}{name}")?;
            between = ", ";
        }
        if self.is_empty() { f.write_str("none") } else { Ok(()) }
    }
}
