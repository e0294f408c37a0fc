//! Cycle times that a drive does not take. The S400 and the S600 take a position every millisecond, a velocity every 500 µs and
//! a torque every 250 µs, the S300 and the S700 each of them every 250 µs (S700, 3.10).

use devc_runtime::Device;
use devc_runtime::pdo::ProcessImage;
use devc_runtime::start_up::StartUp as Start;

#[allow(dead_code)]
#[path = "../../../generated/s700/s700.rs"]
mod servo;

#[derive(Device)]
#[device(path = "devices/s700", member = "s400", module = "alone")]
pub struct S400;

use servo::{s400, s600, s700};

/// Set values of all three.
#[derive(Clone, Copy, ProcessImage)]
struct Outputs {
    setpoints: servo::RxPdo1708,
}

#[derive(Clone, Copy, ProcessImage)]
struct Inputs {
    values: servo::TxPdo1B01,
}

/// A position alone: no mode needs to be named.
#[derive(Clone, Copy, ProcessImage)]
struct Position {
    setpoints: servo::RxPdo1701,
}

const ON_S400: Start = Start::on::<Outputs, Inputs>(&s400::BRING_UP);
const ON_S600: Start = Start::on::<Outputs, Inputs>(&s600::BRING_UP);
const ON_S700: Start = Start::on::<Outputs, Inputs>(&s700::BRING_UP);

// each takes these
const _: [Start; 3] = [
    ON_S400.mode(8).cycle_ns::<1_000_000>(),
    ON_S400.mode(9).cycle_ns::<500_000>(),
    ON_S400.mode(10).cycle_ns::<250_000>(),
];
const _: [Start; 3] = [
    ON_S600.mode(8).cycle_ns::<1_000_000>(),
    ON_S600.mode(9).cycle_ns::<500_000>(),
    ON_S600.mode(10).cycle_ns::<250_000>(),
];
const _: [Start; 2] = [ON_S700.mode(8).cycle_ns::<250_000>(), ON_S600.cycle_ns::<250_000>()];

// and none of these
const _: Start = ON_S400.mode(8).cycle_ns::<500_000>();
const _: Start = ON_S600.mode(8).cycle_ns::<900_000>();
const _: Start = ON_S600.mode(9).cycle_ns::<250_000>();
const _: Start = ON_S400.mode(10).cycle_ns::<200_000>();
const _: Start = ON_S700.mode(8).cycle_ns::<200_000>();

// the mode may come after the cycle time
const _: Start = ON_S600.cycle_ns::<250_000>().mode(9);

// of all members that take the images, each has to take the cycle time
const _: Start = Start::of::<Outputs, Inputs>().mode(8).cycle_ns::<250_000>();
const _: Start = Start::of::<Position, Inputs>().cycle_ns::<250_000>();

// 0x60C2 cannot hold it
const _: Start = ON_S700.cycle_ns::<1_234_000>();

// a member that is compiled alone
#[derive(Clone, Copy, ProcessImage)]
pub struct OfOne {
    pub setpoints: alone::RxPdo1708,
}

#[derive(Clone, Copy, ProcessImage)]
pub struct FromOne {
    pub values: alone::TxPdo1B01,
}

const _: Start = Start::of::<OfOne, FromOne>().mode(9).cycle_ns::<500_000>();
const _: Start = Start::of::<OfOne, FromOne>().mode(8).cycle_ns::<500_000>();

fn main() {}
