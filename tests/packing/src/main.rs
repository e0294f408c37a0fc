//! One subject after another, each often; [`next_subject`] stands between them, so that callgrind tells them apart.
//!
//! Without an argument it prints the names of the subjects, in their order; with a number it runs each so often.

mod lookup;
mod packing;

use std::hint::black_box;

/// The C-887's generated module.
#[rustfmt::skip]
#[path = "../../../generated/c887/c887.rs"]
mod c887;

/// What is measured, or named.
pub enum Task {
    Name,
    Run(u32),
}

impl Task {
    /// Runs a subject as often as asked, or names it.
    pub fn subject(&self, name: &str, mut subject: impl FnMut()) {
        match self {
            Self::Name => println!("{name}"),
            Self::Run(rounds) => {
                next_subject();
                for _ in 0..*rounds {
                    subject();
                }
            }
        }
    }
}

/// The mark between subjects.
#[inline(never)]
fn next_subject() {
    black_box(());
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|rounds| rounds.parse().ok());
    let task = rounds.map_or(Task::Name, Task::Run);
    packing::run(&task);
    lookup::run(&task);
    task.subject("end", || {});
}
