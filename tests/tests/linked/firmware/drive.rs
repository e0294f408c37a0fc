//! The side of the drive.

use core::hint::black_box;

use devc_runtime::cia402::{Coupled, Drive, Events, Machine, ModeSwitch, Modes, Running, State};

use crate::c887::{MACHINE, MODES};
use crate::{pmc_sc6, s700};

pub fn run() {
    of_device(&MACHINE, &MODES);
    of_device(&s700::s700::MACHINE, &s700::s700::MODES);
    of_device(&pmc_sc6::double::MACHINE, &pmc_sc6::double::MODES);
}

#[inline(never)]
fn of_device(machine: &'static Machine, modes: &'static Modes) {
    let (controlword, events) = black_box((0x0006, Events::FAULT));
    let mut drive = Drive::new(machine).resumed(black_box(State::Fault), black_box(0));
    black_box(drive.cycle(controlword, events));
    black_box(drive.statusword(black_box(0)));
    let mut axes = Coupled::<6>::resumed(machine, black_box(State::Fault), black_box(0));
    black_box(axes.cycle(controlword, [events; 6]));
    black_box(axes.statusword(black_box(0)));
    let mut modes = ModeSwitch::new(modes);
    black_box(modes.cycle(black_box(8), black_box(State::OperationEnabled), black_box(Running::Over)));
}
