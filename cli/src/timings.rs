//! What each stage costs.

use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// A stopwatch with named laps.
pub(super) struct Timings {
    since: Instant,
    laps: Vec<(String, Duration)>,
    open: Option<String>,
}

impl Timings {
    /// Starts with no lap.
    pub(super) fn start() -> Self {
        Self { since: Instant::now(), laps: Vec::new(), open: None }
    }

    /// Ends the lap that runs and begins another.
    pub(super) fn enter(&mut self, name: &str) {
        self.stop();
        self.open = Some(name.to_owned());
    }

    /// Ends the lap that runs.
    pub(super) fn stop(&mut self) {
        let now = Instant::now();
        if let Some(name) = self.open.take() {
            self.laps.push((name, now - self.since));
        }
        self.since = now;
    }

    /// Adds a lap that was run elsewhere.
    pub(super) fn add(&mut self, name: &str, time: Duration) {
        self.laps.push((name.to_owned(), time));
    }

    /// A table of the laps with their sum, in milliseconds.
    pub(super) fn table(&self, title: &str) -> String {
        let total = ("total", self.laps.iter().map(|(_, time)| *time).sum::<Duration>());
        let laps = self.laps.iter().map(|(name, time)| (name.as_str(), *time));
        let mut out = title.to_owned();
        for (name, time) in laps.chain([total]) {
            let _ = write!(out, "\n  {name:<10}{:>9.3} ms", time.as_secs_f64() * 1e3);
        }
        out
    }
}
