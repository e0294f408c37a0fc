//! Process data to bytes and back, and finding an entry by its address, against other ways: in instructions, which do
//! not depend on what else the machine does, and in bytes of code and of stack.
//!
//! `cargo bench -p devc-tests --bench packing [-- LEVELS]`. It needs valgrind and a C compiler, for code and stack nm
//! and objdump, too; it builds `tests/packing`, which is a workspace of its own, at each level of optimisation, such as
//! `3` or `s,lto`. Each way is first checked to have each field at its place. What is compared with is a function in C
//! that shifts each field into its bytes, at the same level; the call itself is not counted.
#![allow(clippy::print_stdout, reason = "a benchmark is there to print")]

mod code;
#[path = "../measure/mod.rs"]
mod measure;
mod program;
mod table;

use measure::Fallible;
use program::{Measured, Program};
use table::{Table, WIDTH};

const LEVELS: [&str; 6] = ["3", "3,lto", "s", "s,lto", "z", "z,lto"];

/// What the others are compared with.
const REFERENCE: &str = "C, field by field";

const IMAGES: [&str; 4] = ["C-887 outputs", "C-887 inputs", "S700 inputs", "Pilz inputs"];

fn main() -> Fallible<()> {
    let asked: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let levels = if asked.is_empty() { LEVELS.map(str::to_owned).to_vec() } else { asked };
    let mut all = Vec::new();
    for level in &levels {
        all.push(Program::built(level)?.measured()?);
    }
    let table = Table { levels: &levels, ways: all.first().map(Measured::ways).unwrap_or_default() };
    table.print("instructions of C, mean of the images: pack / unpack", |way, level| {
        ratios(all.get(level)?, way, instructions).map(|ratio| both(ratio.map(mean), 2))
    });
    table.print("instructions of C, worst of the images: pack / unpack", |way, level| {
        ratios(all.get(level)?, way, instructions).map(|ratio| both(ratio.map(worst), 2))
    });
    table.print("bytes of code of C, mean of the images: pack / unpack", |way, level| {
        ratios(all.get(level)?, way, code).map(|ratio| both(ratio.map(mean), 2))
    });
    for image in IMAGES {
        table.print(&format!("bytes of stack, {image}: pack / unpack"), |way, level| {
            let measured = all.get(level)?;
            let stack = |what: &str| measured.stack.get(&format!("{way}, {what} {image}")).copied();
            Some(both([stack("pack")?, stack("unpack")?], 0))
        });
    }
    table.print("instructions a lookup", |way, level| {
        let cost = all.get(level)?.instructions.get(&format!("{way}, lookup"))?;
        Some(format!("{cost:>WIDTH$.1}"))
    });
    Ok(())
}

fn both([pack, unpack]: [f64; 2], decimals: usize) -> String {
    format!("{:>WIDTH$}", format!("{pack:.decimals$} / {unpack:.decimals$}"))
}

fn instructions(measured: &Measured, subject: &str) -> Option<f64> {
    measured.instructions.get(subject).copied()
}

fn code(measured: &Measured, subject: &str) -> Option<f64> {
    measured.code.get(subject).copied()
}

/// How much more a way takes than the reference, for each image: to pack, and to unpack.
fn ratios(
    measured: &Measured,
    way: &str,
    figure: fn(&Measured, &str) -> Option<f64>,
) -> Option<[[f64; 4]; 2]> {
    let mut ratios = [[0.0; 4]; 2];
    for (what, ratios) in ["pack", "unpack"].into_iter().zip(&mut ratios) {
        for (image, ratio) in IMAGES.into_iter().zip(ratios) {
            let own = figure(measured, &format!("{way}, {what} {image}"))?;
            *ratio = own / figure(measured, &format!("{REFERENCE}, {what} {image}"))?;
        }
    }
    Some(ratios)
}

/// The geometric mean.
fn mean(ratios: [f64; 4]) -> f64 {
    ratios.into_iter().product::<f64>().sqrt().sqrt()
}

fn worst(ratios: [f64; 4]) -> f64 {
    ratios.into_iter().fold(0.0, f64::max)
}
