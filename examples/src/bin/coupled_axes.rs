//! A master enables the six coupled axes of the C-887 and moves the platform along a circle in CSP. The drive side runs
//! in the same process; only frames go from one to the other.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use devc_generated::c887::{
    Controlword, Inputs, MACHINE, ModeOfOperation, Outputs, RxPdo1600, Statusword, TxPdo1A00, units,
};
use devc_runtime::cia402::{Coupled, Events, Feedback, Goal, Master, Mode, ModeSwitch, Running};
use devc_runtime::unit::Length;

/// The drive side: six axes that share a state.
struct Hexapod {
    axes: Coupled<6>,
    mode: ModeSwitch,
    positions: [i32; 6],
    /// The widest step that an axis was told to make in a cycle.
    jump: u32,
}

impl Hexapod {
    fn cycle(&mut self, frame: [u8; 42]) -> [u8; 66] {
        let [first, ..] = Outputs::unpack(frame).axes;
        if let Some(step) = self.axes.cycle(first.controlword.0, [Events::INITIALISED; 6]) {
            println!("drive   {step}");
        }
        self.mode.cycle(first.modes_of_operation, self.axes.state(), Running::Over);
        if ModeOfOperation::decode(self.mode.display()) == Ok(ModeOfOperation::Csp) {
            for (position, axis) in self.positions.iter_mut().zip(Outputs::unpack(frame).axes) {
                self.jump = self.jump.max(position.abs_diff(axis.target_position));
                *position = axis.target_position;
            }
        }
        self.report()
    }

    fn report(&self) -> [u8; 66] {
        let axes = self.positions.map(|position| TxPdo1A00 {
            statusword: Statusword(self.axes.statusword(0)),
            modes_of_operation_display: self.mode.display(),
            position_actual_value: position,
            following_error_actual_value: 0,
        });
        Inputs { axes }.pack()
    }
}

/// Where the platform is in X and Y after so many cycles: a circle of 5 mm through the place where it began. It starts
/// and ends at rest: the path has to be smooth (C887T0011, CSP).
fn path(cycle: u32) -> [i32; 2] {
    let turn = core::f64::consts::TAU * f64::from(cycle) / 1000.0;
    let angle = turn - turn.sin();
    let circle = [5.0 * angle.cos() - 5.0, 5.0 * angle.sin()];
    circle.map(|millimetres| {
        let nanometres = Length::nanometres((millimetres * 1e6) as i64);
        units::POSITION_MM.saturating(nanometres)
    })
}

fn main() {
    let start = [150_000, -200_000, 0, 0, 0, 0];
    let (axes, mode) = (Coupled::new(&MACHINE), ModeSwitch::new(&MACHINE.modes));
    let mut hexapod = Hexapod { axes, mode, positions: start, jump: 0 };
    let mut master = Master::new(&MACHINE);
    let known = master.select(ModeOfOperation::Csp.code());
    println!("master  mode {}: {known:?}", ModeOfOperation::Csp);
    master.request(Goal::OperationEnabled);

    let (mut inputs, mut targets, mut seeded) = (hexapod.report(), [0; 6], false);
    let (mut cycle, mut before) = (0, None);
    while cycle < 1000 {
        let actual = Inputs::unpack(inputs).axes;
        let [first, ..] = actual;
        let mode = first.modes_of_operation_display;
        let output = master.cycle(Feedback { statusword: first.statusword.0, mode, seeded });
        if before.replace(output.progress) != Some(output.progress) {
            println!("master  {}", output.progress);
        }
        seeded = output.seed;
        if output.seed {
            targets = actual.map(|axis| axis.position_actual_value);
        }
        if output.motion {
            cycle += 1;
            for ((target, start), moved) in targets.iter_mut().zip(start).zip(path(cycle)) {
                *target = start + moved;
            }
        }
        let (controlword, modes_of_operation) = (Controlword(output.controlword), output.mode);
        let axes =
            targets.map(|target_position| RxPdo1600 { controlword, modes_of_operation, target_position });
        inputs = hexapod.cycle(Outputs { axes }.pack());
    }
    let off = hexapod.positions.iter().zip(start).map(|(is, was)| is.abs_diff(was)).max();
    let [jump, off] =
        [hexapod.jump, off.unwrap_or(0)].map(|steps| units::POSITION_MM.physical(steps).in_micrometres());
    println!("drive   {} on all axes, the widest step {jump:.1} µm", hexapod.axes.state());
    println!("drive   back within {off:.0} µm");
}
