//! When a run ends: after a time, or when somebody asks for it.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

/// What a shell calls the end of a program by Ctrl-C.
const INTERRUPTED: i32 = 130;

/// The end of a run.
#[derive(Debug)]
pub(super) struct Ending {
    begin: Instant,
    after: Option<Duration>,
    is_asked: Arc<AtomicBool>,
}

impl Ending {
    /// After a time, if there is one, or at Ctrl-C, so that files are whole. Who asks a second time does not want to wait.
    pub(super) fn after(after: Option<Duration>) -> io::Result<Self> {
        let is_asked = Arc::new(AtomicBool::new(false));
        for signal in [SIGINT, SIGTERM] {
            flag::register_conditional_shutdown(signal, INTERRUPTED, Arc::clone(&is_asked))?;
            flag::register(signal, Arc::clone(&is_asked))?;
        }
        Ok(Self { begin: Instant::now(), after, is_asked })
    }

    /// Whether it has come.
    pub(super) fn has_come(&self) -> bool {
        self.is_asked.load(Ordering::Relaxed) || self.after.is_some_and(|after| self.begin.elapsed() >= after)
    }
}
