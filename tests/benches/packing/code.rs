//! The code of the functions: its size by `nm`, and what it takes of the stack by `objdump`.

use std::collections::BTreeMap;
use std::env::consts::ARCH;
use std::path::Path;
use std::process::Command;

use crate::measure::{Fallible, run};

/// What is known of the functions, by subject; nothing without the tools.
#[derive(Default)]
pub(crate) struct Code {
    pub(crate) bytes: BTreeMap<String, f64>,
    pub(crate) stack: BTreeMap<String, f64>,
}

/// The code of functions of a program, each as its distance from `subject_mark` and its subject.
pub(crate) fn of(program: &Path, functions: &[String]) -> Fallible<Code> {
    let mut code = Code::default();
    let Some(symbols) = text(Command::new("nm").arg("-S").arg(program)) else { return Ok(code) };
    let (mark, sizes) = symbols_in(&symbols).ok_or("the program has no symbol `subject_mark`")?;
    let objdump = text(Command::new("objdump").args(["-d", "--no-show-raw-insn"]).arg(program));
    let lines = objdump.filter(|_| ARCH == "x86_64").map(|text| instructions_in(&text)).unwrap_or_default();
    for (distance, subject) in functions.iter().filter_map(|function| function.split_once(' ')) {
        let start = mark.wrapping_add_signed(distance.parse()?);
        let Some(size) = sizes.get(&start) else { continue };
        code.bytes.insert(subject.to_owned(), *size as f64);
        let own: Vec<&str> = lines.range(start..start + size).map(|(_, line)| line.as_str()).collect();
        if !own.is_empty() {
            code.stack.insert(subject.to_owned(), deepest(&own) as f64);
        }
    }
    Ok(code)
}

/// What a tool prints; none if it is not there.
fn text(command: &mut Command) -> Option<String> {
    String::from_utf8(run(command).ok()?.stdout).ok()
}

/// The address of the mark, and the size of each symbol by its address.
fn symbols_in(text: &str) -> Option<(u64, BTreeMap<u64, u64>)> {
    let (mut mark, mut sizes) = (None, BTreeMap::new());
    for line in text.lines() {
        let fields: Vec<&str> = line.split_whitespace().collect();
        let [address, size, _, name] = fields[..] else { continue };
        let (Ok(address), Ok(size)) = (u64::from_str_radix(address, 16), u64::from_str_radix(size, 16))
        else {
            continue;
        };
        sizes.insert(address, size);
        if name.contains("subject_mark") {
            mark = Some(address);
        }
    }
    Some((mark?, sizes))
}

/// The instructions by their addresses.
fn instructions_in(text: &str) -> BTreeMap<u64, String> {
    let lines = text.lines().filter_map(|line| {
        let (address, instruction) = line.split_once(':')?;
        Some((u64::from_str_radix(address.trim(), 16).ok()?, instruction.trim().to_owned()))
    });
    lines.collect()
}

/// How deep a function's stack gets: what it pushes, what it takes at once, and what it uses below that.
fn deepest(instructions: &[&str]) -> i64 {
    let (mut depth, mut deepest) = (0, 0);
    for instruction in instructions {
        let (name, operands) = instruction.split_once(char::is_whitespace).unwrap_or((instruction, ""));
        depth += match name {
            "push" => 8,
            "pop" => -8,
            "sub" => constant(operands).unwrap_or(0),
            "add" => -constant(operands).unwrap_or(0),
            _ => 0,
        };
        deepest = deepest.max(depth + below(operands));
    }
    deepest
}

/// The constant that is added to the stack pointer, or subtracted from it.
fn constant(operands: &str) -> Option<i64> {
    let digits = operands.trim().strip_prefix("$0x")?.strip_suffix(",%rsp")?;
    u64::from_str_radix(digits, 16).ok().map(u64::cast_signed)
}

/// The bytes below the stack pointer that an operand uses, as a function that calls no other may.
fn below(operands: &str) -> i64 {
    let Some((before, _)) = operands.split_once("(%rsp") else { return 0 };
    let offset = before.rsplit_once("-0x").and_then(|(_, digits)| i64::from_str_radix(digits, 16).ok());
    offset.unwrap_or(0)
}
