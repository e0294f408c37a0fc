//! Each kind of description in two sizes, by what is allocated for it: a count that is the same on any machine, however busy.
//!
//! It sees copies of what is there already, lists and texts that are made again for each of many, and messages nobody reads;
//! not a search that only compares. That shows in time, which [`growth`](super::growth) measures where it is asked to.

use allocation_counter::measure;
use devc::diagnostic::render::{Style, text};
use devc::emit::json::Json;
use devc::emit::{self, Emitter, Options};
use devc_tests::hostile::{Files, Kind};

use crate::{compile, found};

/// How many times as many allocations as the input or the output has grown by are still growth with it: what is linear
/// takes 1, what is square 4.
const GROWTH: u64 = 2;

/// How many allocations do not count: those of a few messages more.
const NOTHING: u64 = 2_000;

/// What something took.
#[derive(Clone, Copy)]
struct Cost {
    allocations: u64,
    /// How large what came of it is: a range of subindices, an axis or a likeness makes a short description long.
    size: usize,
}

/// Compiles a description and says what is wrong with it.
fn compiled(files: Files) -> Cost {
    let mut family = None;
    let taken = measure(|| {
        let mut compilation = compile(files);
        compilation.diagnostics.cut(20);
        for diagnostic in compilation.diagnostics.iter() {
            drop(text(diagnostic, &compilation.sources, Style::Plain));
        }
        family = compilation.family;
    });
    let model = family.map(|family| Json.emit(&family, &Options::default()).0);
    let size = model.into_iter().flat_map(|files| files.into_values()).map(|content| content.len()).sum();
    Cost { allocations: taken.count_total, size }
}

/// Makes the outputs of a description.
fn made(files: Files) -> Cost {
    let compilation = compile(files);
    let mut size = 0;
    let taken = measure(|| {
        let made = |family| emit::emit(family, emit::ALL, &Options::default()).0.into_values();
        let contents = compilation.family.iter().flat_map(made);
        size = contents.map(|content| content.len()).sum();
    });
    Cost { allocations: taken.count_total, size }
}

/// Why a kind grows too fast, if it does: it is measured with so many and with four times as many.
fn judge(kind: &Kind, cost: fn(Files) -> Cost, many: usize) -> Option<String> {
    let [nothing, some, more] = [1, many, 4 * many].map(|many| cost((kind.files)(many)));
    let allocations = |cost: Cost| cost.allocations.saturating_sub(nothing.allocations);
    let (before, after) = (allocations(some).max(NOTHING), allocations(more));
    let size = |cost: Cost| cost.size.saturating_sub(nothing.size);
    let larger = u64::try_from(size(more) / size(some).max(1)).unwrap_or(u64::MAX).max(4);
    (after > GROWTH * larger * before)
        .then(|| format!("{}: {before} allocations for {many}, {after} for four times as many", kind.name))
}

fn all_grow_slowly(cost: fn(Files) -> Cost, many: usize) {
    let fast = found(|kind| judge(kind, cost, many));
    assert!(fast.is_empty(), "these grow too fast:\n{}", fast.join("\n"));
}

#[test]
fn work_grows_with_the_input() {
    all_grow_slowly(compiled, 40);
}

/// Of each kind, which is more than any device has of it, every output can be made.
#[test]
fn outputs_are_made_in_work_that_grows_with_their_size() {
    all_grow_slowly(made, 10);
}
