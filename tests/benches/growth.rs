//! How the cost of a description grows with its size, stage by stage.
//!
//! `cargo bench -p devc-tests --bench growth [-- ENTRIES..]`. Descriptions of each shape are made in memory:
//!
//! - *records*: single values and records of seven entries by turns, in the manufacturer's area;
//! - *values*: one value an object, from 0x2000 to the end of the dictionary, where there are 57 344;
//! - *axes*: as *records*, but written once for two axes.
//!
//! Linear growth shows in equal costs an entry from top to bottom.
#![allow(clippy::print_stdout, reason = "a benchmark is there to print")]

mod measure;

use std::env;
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use devc::emit;
use devc::source::Memory;
use measure::{Fallible, instructions, run};

const SIZES: [usize; 4] = [1_000, 4_000, 16_000, 65_000];

/// Up to here instructions are counted: beyond it that takes longer than anybody waits.
const COUNTED: usize = 16_000;

fn main() -> Fallible<()> {
    let arguments: Vec<String> = env::args().skip(1).filter(|argument| argument != "--bench").collect();
    if let [shape, entries] = &arguments[..]
        && let Some(shape) = Shape::ALL.into_iter().find(|known| known.name() == shape)
    {
        return stages(shape, entries.parse()?);
    }
    let sizes = arguments.iter().map(|size| Ok(size.parse()?)).collect::<Fallible<Vec<usize>>>()?;
    let sizes = if sizes.is_empty() { SIZES.to_vec() } else { sizes };
    for shape in Shape::ALL {
        table(shape, &sizes)?;
    }
    Ok(())
}

/// What a description is made of.
#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Records,
    Values,
    Axes,
}

impl Shape {
    const ALL: [Self; 3] = [Self::Records, Self::Values, Self::Axes];

    fn name(self) -> &'static str {
        match self {
            Self::Records => "records",
            Self::Values => "values",
            Self::Axes => "axes",
        }
    }

    /// A description with about as many entries, those of all axes counted.
    fn description(self, entries: usize) -> String {
        let mut text = HEAD.to_owned();
        if self == Self::Axes {
            text += "[axes]\nnames = [\"left\", \"right\"]\nshifts = [{ range = \"0x2000..=0x3FFF\", by = 0x2000 }]\n";
        }
        let wanted = if self == Self::Axes { entries / 2 } else { entries };
        let (mut made, mut index) = (0, 0x2000);
        while made < wanted && index <= 0xFFFF {
            let record = self != Self::Values && index % 2 == 1;
            made += object(&mut text, index, record);
            index += 1;
        }
        text
    }
}

const HEAD: &str = r#"
profiles = ["ethercat"]
[device]
name = "Generated"
vendor = "Example"
[identity]
vendor-id = 1
product-code = 2
revision = 3
[units]
increments = { quantity = "position", symbol = "inc" }
[mailbox]
protocols = ["CoE"]
[objects.0x1000]
[objects.0x1018]
[sync-managers.outputs]
address = 0x1100
control = 0x64
pdos = ["0x1600"]
[rx-pdos.0x1600]
name = "Setpoints"
entries = ["0x2000"]
"#;

/// Writes an object, and says how many entries it has.
fn object(text: &mut String, index: u32, record: bool) -> usize {
    let _ = writeln!(text, "[objects.0x{index:04X}]\nname = \"Gauge {index}\"");
    text.push_str(
        "about = \"What the gauge of this number measures, and over what time.\"\naccess = \"rw\"\n",
    );
    if !record {
        let _ = writeln!(text, "type = \"INT32\"\nunit = \"increments\"\npdo = \"rx-tx\"\ndefault = {index}");
        text.push_str("min = -100_000\nmax = 100_000\n");
        if index.is_multiple_of(16) {
            text.push_str("values = { -1 = \"Left\", 0 = \"Still\", 1 = \"Right\" }\n");
        }
        return 1;
    }
    let _ = writeln!(text, "type = \"UINT16\"\n[objects.0x{index:04X}.entries]");
    for subindex in 1..=7 {
        let _ = writeln!(
            text,
            "{subindex} = {{ name = \"Sample {subindex}\", default = {subindex}, max = 1000 }}"
        );
    }
    8
}

/// Compiles a description and makes its outputs; prints what each stage took, then the number of entries and the
/// most memory in kB that the process held.
fn stages(shape: Shape, entries: usize) -> Fallible<()> {
    let loader = Memory::new().with("generated/device.toml", shape.description(entries));
    let mut laps = Vec::new();
    let path = Path::new("generated");
    let request = devc::Request::default();
    let compilation =
        devc::compile_with(&loader, path, &request, &mut |stage| stage_begins(&mut laps, stage.name()));
    let Some(family) = compilation.family else {
        let messages: Vec<_> = compilation.diagnostics.iter().take(3).map(|it| &it.message).collect();
        return Err(format!("the description has errors: {messages:?}").into());
    };
    for emitter in emit::ALL {
        stage_begins(&mut laps, emitter.name());
        black_box(emitter.emit(&family, &devc::emit::Options::default()));
    }
    stage_begins(&mut laps, "end");
    for pair in laps.windows(2) {
        if let [(name, begin), (_, end)] = pair {
            println!("{name} {}", (*end - *begin).as_nanos());
        }
    }
    let entries: usize = family.members.iter().flat_map(|it| &it.objects).map(|it| it.entries.len()).sum();
    println!("entries {entries}\nmemory {}", peak().unwrap_or(0));
    Ok(())
}

/// Where the counts of the stages are cut: its name is given to callgrind.
#[inline(never)]
fn stage_begins(laps: &mut Vec<(&'static str, Instant)>, name: &'static str) {
    laps.push((name, Instant::now()));
}

/// The most memory this process held, in kB, where Linux tells.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse().ok()
}

/// What a process found out about itself.
struct Run {
    stages: Vec<(String, f64)>,
    entries: f64,
    memory: f64,
}

fn read(text: &str) -> Fallible<Run> {
    let mut run = Run { stages: Vec::new(), entries: 0.0, memory: 0.0 };
    for line in text.lines() {
        let (name, value) = line.split_once(' ').ok_or("a line without a value")?;
        let value: f64 = value.parse()?;
        match name {
            "entries" => run.entries = value,
            "memory" => run.memory = value,
            _ => run.stages.push((name.to_owned(), value)),
        }
    }
    Ok(run)
}

/// Two lines a size: nanoseconds an entry, the best of three runs, and instructions an entry.
fn table(shape: Shape, sizes: &[usize]) -> Fallible<()> {
    println!("\n{}: an entry costs", shape.name());
    for (i, size) in sizes.iter().enumerate() {
        let mut command = Command::new(env::current_exe()?);
        command.args([shape.name(), &size.to_string()]);
        let mut best = once(&mut command)?;
        for _ in 0..2 {
            let again = once(&mut command)?;
            best.stages.iter_mut().zip(again.stages).for_each(|(best, (_, time))| best.1 = best.1.min(time));
        }
        if i == 0 {
            let names = best.stages.iter().map(|(name, _)| name.as_str()).chain(["all", "entries/s", "kB"]);
            let names: String = names.map(|name| format!("{name:>10}")).collect();
            println!("{:>8}{:>8}{names}", "entries", "");
        }
        let times: Vec<f64> = best.stages.iter().map(|(_, ns)| ns / best.entries).collect();
        let all: f64 = times.iter().sum();
        let (rate, memory) = (1e9 / all, best.memory / best.entries);
        println!("{:>8}{:>8}{}{rate:>10.0}{memory:>10.1}", best.entries, "ns", row(&times));
        if *size <= COUNTED
            && let Some(parts) = instructions(&command, Some("stage_begins"))?
        {
            // Before the first stage the description is made, after the last one the result is printed.
            let stages = parts.iter().skip(1).take(times.len());
            println!(
                "{:>8}{:>8}{}",
                "",
                "instr",
                row(&stages.map(|part| *part as f64 / best.entries).collect::<Vec<_>>())
            );
        }
    }
    Ok(())
}

fn once(command: &mut Command) -> Fallible<Run> {
    read(&String::from_utf8(run(command)?.stdout)?)
}

/// The columns and their sum.
fn row(values: &[f64]) -> String {
    let all: f64 = values.iter().sum();
    values.iter().chain([&all]).map(|value| format!("{value:>10.0}")).collect()
}
