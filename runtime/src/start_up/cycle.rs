//! The cycle times that a device takes.

/// Cycle times that a device takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CycleLimit {
    /// The shortest in nanoseconds; 0 if none is told.
    pub least_ns: u64,
    /// The only ones, in nanoseconds; any if there are none.
    pub choices_ns: &'static [u64],
}

impl CycleLimit {
    /// Whether one of several limits takes a cycle time; where there are none, any is taken.
    ///
    /// ```
    /// use devc_runtime::start_up::CycleLimit;
    ///
    /// const POSITION: CycleLimit = CycleLimit { least_ns: 1_000_000, choices_ns: &[] };
    /// assert!(CycleLimit::any_takes(&[POSITION], 2_000_000));
    /// assert!(!CycleLimit::any_takes(&[POSITION], 250_000));
    /// assert!(CycleLimit::any_takes(&[], 250_000));
    /// ```
    pub const fn any_takes(mut limits: &[Self], ns: u64) -> bool {
        let is_limited = !limits.is_empty();
        while let Some((limit, rest)) = limits.split_first() {
            if ns >= limit.least_ns && limit.has_choice(ns) {
                return true;
            }
            limits = rest;
        }
        !is_limited
    }

    const fn has_choice(&self, ns: u64) -> bool {
        let mut choices = self.choices_ns;
        while let Some((choice, rest)) = choices.split_first() {
            if *choice == ns {
                return true;
            }
            choices = rest;
        }
        self.choices_ns.is_empty()
    }
}
