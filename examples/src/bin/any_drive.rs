//! One program for every drive of a family, whichever is on the bus: what they share stands once, so there are no types
//! of a single one in it.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use devc_generated::s700::{
    Controlword, Family, MACHINE, ModeOfOperation, RxPdo1701, Statusword, TxPdo1B01, objects,
};
use devc_runtime::Family as _;
use devc_runtime::cia402::{Drive, Events, Feedback, Goal, Master};
use devc_runtime::object::{Entry, Readable, Value};
use devc_runtime::pdo::{InPlace, Pdo, ProcessData, ProcessImage};
use devc_runtime::start_up::{BringUp, StartUp, Write};

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
struct Outputs {
    setpoint: RxPdo1701,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
struct Inputs {
    actual: TxPdo1B01,
}

/// The list is the same for all: a difference between two of them that bears on it would not compile.
const CHOICE: StartUp = StartUp::of::<Outputs, Inputs>().mode(ModeOfOperation::Csp as i8);
const START_UP: [Write; CHOICE.len()] = CHOICE.writes();

/// Each takes these images; nor would it compile if one did not.
const _: () = {
    let mut members = Family::MEMBERS;
    while let Some((member, rest)) = members.split_first() {
        assert!(member.takes::<Outputs>() && member.takes::<Inputs>());
        members = rest;
    }
};

/// What a mailbox answers for an entry of the family.
fn read<T: Value, A: Readable>(entry: Entry<Family, T, A>, data: &[u8]) -> Option<T> {
    entry.decode(data).ok()
}

/// Enables a drive and gives it a setpoint.
fn run(device: &BringUp) {
    let (mut drive, mut master) = (Drive::new(&MACHINE), Master::new(&MACHINE));
    let (mut outputs, mut seeded) = ([0; Outputs::LEN], false);
    master.request(Goal::OperationEnabled);
    for _ in 0..20 {
        let feedback = Feedback { statusword: drive.statusword(0), mode: 0, seeded };
        let output = master.cycle(feedback);
        seeded = output.seed;
        let mut view = Outputs::view_of_mut(&mut outputs);
        if let Ok(view) = &mut view {
            view.setpoint_mut().set_controlword(Controlword(output.controlword));
        }
        drive.cycle(Outputs::unpack(outputs).setpoint.controlword.0, Events::INITIALISED);
    }
    println!("{}: {}", device.name, Statusword(drive.statusword(0)));
}

fn main() {
    println!("0x{:04X} and 0x{:04X} on each drive of the family:", RxPdo1701::INDEX, TxPdo1B01::INDEX);
    for write in START_UP {
        println!("  {write}");
    }
    println!("{:?}", read(objects::DEVICE_TYPE, &0x0002_0192_u32.to_le_bytes()));
    Family::MEMBERS.iter().for_each(run);
}
