//! Whether the axis is where it should be (CiA 402, following error).

/// What is allowed, in steps and seconds.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    pub(super) width: f64,
    pub(super) time: f64,
}

/// A following error, and how long it has been too large.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Lag {
    error: f64,
    since: f64,
}

impl Lag {
    /// One cycle: where the axis should be, and is. Without a window nothing is too much.
    pub(super) fn cycle(&mut self, error: f64, window: Option<Window>, time: f64) {
        self.error = error;
        let is_beyond = window.is_some_and(|window| error.abs() > window.width);
        self.since = if is_beyond { self.since + time } else { 0.0 };
    }

    /// The difference, in steps.
    pub(super) const fn error(&self) -> f64 {
        self.error
    }

    /// Whether it has been too large for too long.
    pub(super) fn is_too_large(&self, window: Option<Window>) -> bool {
        window.is_some_and(|window| self.error.abs() > window.width && self.since >= window.time)
    }
}
