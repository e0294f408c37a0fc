//! Both axes of a Pilz double axis look for their reference, each with a state of its own. One finds its limit switch;
//! on the other it is not connected, and homing fails.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use devc_generated::pmc_sc6::double::{Axis, HOMING, HomingMethod, MACHINE, ModeOfOperation};
use devc_runtime::cia402::{
    Drive, Events, Feedback, Goal, Homing, HomingMethod as _, HomingProgress, Master, Mode, ModeSwitch,
    Running, State, Timing,
};

/// The drive side of an axis: it moves a step a cycle until it meets its switch, or the end of its travel.
struct Motor {
    drive: Drive,
    mode: ModeSwitch,
    position: i32,
    switch: Option<i32>,
    /// The bits of homing in the statusword.
    shown: u16,
}

impl Motor {
    fn cycle(&mut self, controlword: u16, mode: i8) {
        self.drive.cycle(controlword, Events::INITIALISED);
        self.mode.cycle(mode, self.drive.state(), Running::Over);
        let homes = self.drive.state() == State::OperationEnabled && self.mode.display() == 6;
        if !homes || controlword & HOMING.start == 0 {
            self.shown = if self.shown == 0 { HOMING.reached } else { self.shown };
        } else if self.switch == Some(self.position) {
            self.shown = HOMING.reached | HOMING.attained;
        } else if self.position < -1000 {
            self.shown = HOMING.reached | HOMING.error;
        } else {
            self.shown = 0;
            self.position -= 1;
        }
    }
}

fn main() {
    let method = HomingMethod::HOMING_ON_NEGATIVE_LIMIT_SWITCH;
    println!("method {method}");
    if let Some(info) = method.info() {
        println!("  looks for the {}: {}", info.target, info.text);
    }
    for (axis, switch) in Axis::ALL.into_iter().zip([Some(-200), None]) {
        let (drive, mode) = (Drive::new(&MACHINE), ModeSwitch::new(&MACHINE.modes));
        let motor = Motor { drive, mode, position: 300, switch, shown: HOMING.reached };
        println!("axis {axis:?}");
        home(motor);
    }
}

/// The master side of an axis.
fn home(mut motor: Motor) {
    let mut master = Master::new(&MACHINE);
    if let Err(unknown) = master.select(ModeOfOperation::Hm.code()) {
        println!("  {unknown}");
    }
    master.request(Goal::OperationEnabled);
    let mut homing = Homing::new(HOMING, Timing { timeout: 5000, ..Timing::DEFAULT });
    homing.start();
    let (mut seeded, mut before) = (false, HomingProgress::Idle);
    while homing.progress().is_active() {
        let (statusword, mode) = (motor.drive.statusword(motor.shown), motor.mode.display());
        let output = master.cycle(Feedback { statusword, mode, seeded });
        seeded = output.seed;
        let controlword = homing.cycle(&output, statusword);
        motor.cycle(controlword, output.mode);
        if homing.progress() != before {
            before = homing.progress();
            println!("  {before:?} at {} in {}", motor.position, motor.drive.state());
        }
    }
}
