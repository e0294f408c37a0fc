//! Each kind of description in two sizes: four times as much may take four times as long, and not sixteen times.
//!
//! `cargo test -p devc-tests --release --test bounds -- --ignored` asks; what all others see of it is that every kind is
//! answered at all.

use std::fs;
use std::hint::black_box;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use devc::diagnostic::render::{Style, text};
use devc::emit;
use devc_tests::hostile::{Files, Kind};

use crate::{compile, found};

/// How much longer four times as much may take: twice as long as if it were linear, half as long as if it were square.
const GROWTH: u32 = 8;

/// What is not worth measuring.
const NOTHING: Duration = Duration::from_millis(5);

/// The time that this thread had a processor for, so that what else the machine does is not counted; the time of the
/// clock where the system does not tell.
fn time() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let told = told.and_then(|text| text.split(' ').next()?.parse().ok()).map(Duration::from_nanos);
    told.unwrap_or_else(|| START.elapsed())
}

/// What it takes to compile a description and to say what is wrong with it.
fn compiled(files: Files) -> (Duration, usize) {
    let start = time();
    let mut compilation = compile(files);
    compilation.diagnostics.cut(20);
    for diagnostic in compilation.diagnostics.iter() {
        black_box(text(diagnostic, &compilation.sources, Style::Plain));
    }
    (time() - start, 1)
}

/// What it takes to make the outputs of a description, if it has some, and how large they are: a range of subindices
/// or an axis makes a short description long.
fn made(files: Files) -> (Duration, usize) {
    let compilation = compile(files);
    let start = time();
    let family = compilation.family.iter();
    let sizes = family.flat_map(|family| {
        let files = black_box(emit::emit(family, emit::ALL, &emit::Options::default()));
        files.0.into_values().map(|content| content.len())
    });
    let size = sizes.sum();
    (time() - start, size)
}

/// Why a kind grows too fast, if it does: it is measured with so many and with four times as many.
fn judge(kind: &Kind, cost: fn(Files) -> (Duration, usize), many: usize) -> Option<String> {
    let (nothing, _) = cost((kind.files)(1));
    let (some, small) = cost((kind.files)(many));
    let (more, large) = cost((kind.files)(4 * many));
    let (some, more) = (some.saturating_sub(nothing).max(NOTHING), more.saturating_sub(nothing));
    let larger = u32::try_from(large / small.max(1)).unwrap_or(u32::MAX).div_ceil(4).max(1);
    (more > GROWTH * larger * some)
        .then(|| format!("{}: {some:?} for {many}, {more:?} for four times as many", kind.name))
}

fn all_grow_slowly(cost: fn(Files) -> (Duration, usize), many: usize) {
    // a disturbance does not come twice
    let slow = found(|kind| judge(kind, cost, many).and_then(|_| judge(kind, cost, many)));
    assert!(slow.is_empty(), "these grow too fast:\n{}", slow.join("\n"));
}

#[test]
#[ignore = "compares times, so that it wants a machine that does nothing else"]
fn work_grows_with_the_input() {
    all_grow_slowly(compiled, 1_000);
}

#[test]
#[ignore = "compares times, so that it wants a machine that does nothing else"]
fn outputs_are_made_in_a_time_that_grows_with_their_size() {
    all_grow_slowly(made, 100);
}

/// Long enough for any machine, and a fraction of what it took when all was compared with all.
const PATIENCE: Duration = Duration::from_secs(10);

#[test]
fn every_kind_is_answered() {
    let slow = found(|kind| {
        let (taken, _) = compiled((kind.files)(300));
        (taken > PATIENCE).then(|| format!("300 {}: {taken:?}", kind.name))
    });
    assert!(slow.is_empty(), "these take too long:\n{}", slow.join("\n"));
}
