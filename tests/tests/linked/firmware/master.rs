//! The side of the master.

use core::hint::black_box;

use devc_runtime::cia402::{
    Feedback, Goal, Halt, Homing, Machine, Master, Move, Observer, Output, SetPoints, State, Timing,
};
use devc_runtime::error::ErrorCode as _;
use devc_runtime::unit::Length;

use crate::c887::{Axis, ErrorCode, HOMING, MACHINE, objects, units};
use crate::{pmc_sc6, s700};

pub fn run() {
    of_device(&MACHINE);
    of_device(&s700::s700::MACHINE);
    of_device(&pmc_sc6::double::MACHINE);
    black_box(ErrorCode(black_box(0x7121)).name());
    black_box(units::POSITION_MM.saturating::<i32>(black_box(Length::millimetres(1))));
    black_box(units::POSITION_MM.physical(black_box(1_i32)));
    let origin = objects::work_coordinate_system::AXIS_X;
    black_box(origin.exact(black_box(Length::millimetres(1))).is_ok());
    black_box(objects::position_actual_value(black_box(Axis::X)).physical(black_box(1)));
}

#[inline(never)]
fn of_device(machine: &'static Machine) {
    let mut master = Master::new(machine).timing(black_box(Timing::DEFAULT));
    master.request(black_box(Goal::OperationEnabled));
    master.quick_stop();
    black_box(master.reset_fault());
    black_box(master.select(black_box(8)).is_ok());
    let feedback = black_box(Feedback { statusword: 0x0237, mode: 8, seeded: true });
    let output = master.cycle(feedback);
    in_mode(&output, feedback.statusword);
    let mut observer = Observer::new(machine);
    black_box(observer.observe(black_box(0)).unwrap_or(State::Fault));
}

fn in_mode(output: &Output, statusword: u16) {
    let mut homing = Homing::new(HOMING, Timing::DEFAULT);
    homing.start();
    black_box(homing.cycle(output, statusword));
    let mut points = SetPoints::new(Timing::DEFAULT);
    black_box(points.offer(black_box(Move::ABSOLUTE)));
    black_box(points.cycle(output, statusword));
    let mut halt = Halt::new(Timing::DEFAULT);
    halt.give(black_box(true));
    black_box(halt.cycle(output.controlword, statusword));
}
