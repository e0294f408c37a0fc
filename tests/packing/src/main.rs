//! One subject after another, each often; [`subject_mark`] stands before and after each, so that callgrind tells them
//! apart.
//!
//! Without an argument it prints the names of the subjects, in their order; with a number it runs each so often; with
//! another argument it prints where the functions of the subjects are.

mod lookup;
mod packing;

use std::hint::black_box;

/// The C-887's generated module.
#[rustfmt::skip]
#[path = "../../../generated/c887/c887.rs"]
mod c887;

/// The generated module of the family of the PMC SC6.
#[rustfmt::skip]
#[path = "../../../generated/pmc-sc6/pmc-sc6.rs"]
mod pmc_sc6;

/// The generated module of the family of the S700.
#[rustfmt::skip]
#[path = "../../../generated/s700/s700.rs"]
mod s700;

/// What is measured, named or found.
pub enum Task {
    Name,
    Find,
    Run(u32),
}

impl Task {
    /// Runs a subject as often as asked, or names it.
    pub fn subject(&self, name: &str, mut subject: impl FnMut()) {
        match self {
            Self::Name => println!("{name}"),
            Self::Find => {}
            Self::Run(rounds) => {
                subject_mark();
                for _ in 0..*rounds {
                    subject();
                }
                subject_mark();
            }
        }
    }

    /// Says where the function of a subject is, counted from [`subject_mark`].
    pub fn function(&self, name: &str, address: usize) {
        if let Self::Find = self {
            let from = subject_mark as fn() as usize;
            println!("{} {name}", address.wrapping_sub(from) as isize);
        }
    }
}

/// Where a subject begins or ends.
#[inline(never)]
fn subject_mark() {
    black_box(());
}

fn main() {
    let task = match std::env::args().nth(1).map(|argument| argument.parse()) {
        None => Task::Name,
        Some(Ok(rounds)) => Task::Run(rounds),
        Some(Err(_)) => Task::Find,
    };
    packing::run(&task);
    lookup::run(&task);
}
