//! The side of the drive.

use core::hint::black_box;

use devc_runtime::cia402::{Coupled, Drive, Events, ModeSwitch, Running, State};

use crate::c887::{MACHINE, MODES};

pub fn run() {
    let (controlword, events) = black_box((0x0006, Events::FAULT));
    let mut drive = Drive::new(&MACHINE).resumed(black_box(State::Fault), black_box(0));
    black_box(drive.cycle(controlword, events));
    black_box(drive.statusword(black_box(0)));
    let mut axes = Coupled::<6>::resumed(&MACHINE, black_box(State::Fault), black_box(0));
    black_box(axes.cycle(controlword, [events; 6]));
    black_box(axes.statusword(black_box(0)));
    let mut modes = ModeSwitch::new(&MODES);
    black_box(modes.cycle(black_box(8), black_box(State::OperationEnabled), black_box(Running::Over)));
}
