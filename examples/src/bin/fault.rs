//! A fault of the C-887, what its description says of it, and its reset. Nothing enables the drive again unasked.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use devc_generated::c887::{ErrorCode, MACHINE, ModeOfOperation, state_text};
use devc_runtime::cia402::{Drive, Events, Feedback, Goal, Master, Mode, ModeSwitch, Running};
use devc_runtime::error::ErrorCode as _;

/// The drive, with the error code that it shows in 0x603F.
struct Hexapod {
    drive: Drive,
    mode: ModeSwitch,
    error: ErrorCode,
}

/// Cycles of both sides, with what holds in the drive meanwhile.
fn run(master: &mut Master, hexapod: &mut Hexapod, events: Events) {
    let mut seeded = false;
    for _ in 0..60 {
        let (statusword, mode) = (hexapod.drive.statusword(0), hexapod.mode.display());
        let output = master.cycle(Feedback { statusword, mode, seeded });
        // here a program sets its targets to the actual values
        seeded = output.seed;
        if let Some(step) = hexapod.drive.cycle(output.controlword, events) {
            println!("  {step}");
        }
        hexapod.mode.cycle(output.mode, hexapod.drive.state(), Running::Over);
        if events.any(Events::FAULT) {
            hexapod.mode.clear();
        }
    }
    println!("  {}", state_text(hexapod.drive.state()));
}

fn explain(error: ErrorCode) {
    println!("error {error}");
    if let Some(info) = error.info() {
        let register = info.register.map_or("-".into(), |register| format!("0x{register:02X}"));
        println!("  register {register}, vendor codes {:?}. {}", info.vendor_codes, info.text);
    }
}

fn main() {
    let (drive, mode) = (Drive::new(&MACHINE), ModeSwitch::new(&MACHINE.modes));
    let mut hexapod = Hexapod { drive, mode, error: ErrorCode::NO_ERROR };
    let mut master = Master::new(&MACHINE);
    let quiet = Events::INITIALISED | Events::FAULT_REACTION_OVER;

    println!("asked for operation: {:?}", master.select(ModeOfOperation::Csp.code()));
    master.request(Goal::OperationEnabled);
    run(&mut master, &mut hexapod, quiet);

    println!("a motor is blocked");
    hexapod.error = ErrorCode::MOTOR_BLOCKED;
    run(&mut master, &mut hexapod, quiet | Events::FAULT);
    explain(hexapod.error);

    println!("the motor is free again; nobody has asked for anything");
    hexapod.error = ErrorCode::NO_ERROR;
    run(&mut master, &mut hexapod, quiet);

    println!("asked for a reset: {}", master.reset_fault());
    run(&mut master, &mut hexapod, quiet);

    println!("asked for operation");
    master.request(Goal::OperationEnabled);
    run(&mut master, &mut hexapod, quiet);
    // a code that the description does not know stays visible
    explain(ErrorCode(0x1234));
}
