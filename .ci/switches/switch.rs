//! Which change is on: that of the number in `DEVC_CHANGE`. With `all`, none is, and the numbers of those that are
//! reached go into the file `DEVC_REACHED`. What is evaluated while code is compiled is not changed.

extern crate std;

use std::io::Write;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, Ordering};

enum On {
    Change(u32),
    All,
}

static ON: LazyLock<On> = LazyLock::new(|| match std::env::var("DEVC_CHANGE").as_deref() {
    Ok("all") => On::All,
    number => On::Change(number.ok().and_then(|number| number.parse().ok()).unwrap_or(0)),
});

static SEEN: [AtomicBool; 8192] = [const { AtomicBool::new(false) }; 8192];

#[inline]
pub const fn on(number: u32) -> bool {
    const fn never(_: u32) -> bool {
        false
    }
    core::intrinsics::const_eval_select((number,), never, asked)
}

#[inline]
fn asked(number: u32) -> bool {
    match &*ON {
        On::Change(on) => *on == number,
        On::All => {
            note(number);
            false
        }
    }
}

#[cold]
fn note(number: u32) {
    if SEEN.get(number as usize).is_none_or(|seen| seen.swap(true, Ordering::Relaxed)) {
        return;
    }
    if let Some(path) = std::env::var_os("DEVC_REACHED") {
        let file = std::fs::OpenOptions::new().append(true).create(true).open(path);
        let _ = file.and_then(|mut file| file.write_all(std::format!("{number}\n").as_bytes()));
    }
}
