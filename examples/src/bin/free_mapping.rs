//! An S700 with process data of one's own: the mapping is a struct, and the list that brings the drive up follows.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use devc_generated::s700::s700::{self, Controlword, Statusword, objects};
use devc_runtime::pdo::{InPlace, Pdo, ProcessData, ProcessImage};
use devc_runtime::start_up::{StartUp, Write};

/// What the drive receives in each cycle. A field of another type than its object's would not compile.
#[derive(Debug, Clone, Copy, PartialEq, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
struct Setpoints {
    controlword: Controlword,
    #[pdo(objects::POSITION_SETPOINT)]
    position: i32,
}

/// What it sends. More than the drive takes would not compile either.
#[derive(Debug, Clone, Copy, PartialEq, Pdo)]
#[pdo(mapping = s700::FreeTxPdo1A00)]
struct ActualValues {
    statusword: Statusword,
    #[pdo(objects::POSITION_ACTUAL_VALUE_1)]
    position: i32,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
struct Outputs {
    setpoints: Setpoints,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
struct Inputs {
    actual_values: ActualValues,
}

/// As in the example of its manual: mode 1, 2 ms.
const CHOICE: StartUp = StartUp::cyclic::<Outputs, Inputs, 2_000_000>().mode(1);
const START_UP: [Write; CHOICE.len()] = CHOICE.writes();
const READ_BACK: [Write; CHOICE.verify_len()] = CHOICE.verify();

fn main() {
    println!("{} bytes out, {} bytes in", Outputs::LEN, Inputs::LEN);
    println!("before Safe-Operational:");
    for write in START_UP {
        println!("  {write}");
    }
    println!("then {} values are read back", READ_BACK.len());

    let setpoints = Setpoints { controlword: Controlword(0x000F), position: -1000 };
    let mut frame = Outputs { setpoints }.pack();
    println!("packed: {frame:02X?}");
    Setpoints::view(&mut frame).set_position(1000);
    println!("moved in place: {frame:02X?}");
}
