//! The mistakes that drive code makes in the field, and that code made by devc cannot make: one test for each, on the
//! three devices as their descriptions have them. What is tested here once, `runtime/tests` tries for all words.

#![cfg(test)]

mod axis;

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::cia402::{Events, Feedback, Goal, Machine, Master, Output, State, Timing};
use devc_runtime::unit::{Length, Unfit};

use axis::Axis;

const DEVICES: [(&str, &Machine, i8); 3] = [
    ("C-887", &c887::MACHINE, 8),
    ("S700", &s700::s700::MACHINE, 8),
    ("PMC SC6", &pmc_sc6::double::MACHINE, 8),
];

const TIMING: Timing = Timing { round_trip: 4, resend: 50, timeout: 1000 };

/// A master and an axis, which stands at position 5000 and follows its target while it is enabled.
struct Line {
    device: &'static str,
    master: Master,
    axis: Axis,
    seeded: bool,
}

impl Line {
    fn all(state: State) -> impl Iterator<Item = Self> {
        DEVICES.into_iter().map(move |(device, machine, mode)| {
            let mut master = Master::new(machine).timing(TIMING);
            master.select(mode).expect("a mode of the device");
            Self { device, master, axis: Axis::new(machine, state), seeded: false }
        })
    }

    fn cycle(&mut self) -> Output {
        let (statusword, mode) = (self.axis.statusword(), self.axis.mode());
        let output = self.master.cycle(Feedback { statusword, mode, seeded: self.seeded });
        if output.seed {
            self.axis.target = self.axis.position;
        }
        self.seeded = output.seed;
        self.axis.cycle(output.controlword, output.mode);
        output
    }

    /// Runs until the axis is in that state.
    fn until(&mut self, state: State) {
        for _ in 0..400 {
            self.cycle();
            if self.axis.state() == state {
                return;
            }
        }
        panic!("{}: {} instead of {state}", self.device, self.axis.state());
    }

    /// Runs for a while, in which the axis must never be enabled.
    fn stays_without_power(&mut self) {
        for _ in 0..400 {
            self.cycle();
            assert_ne!(self.axis.state(), State::OperationEnabled, "{}", self.device);
        }
    }
}

/// An entry has its width: 16 bits are not taken from 32, and a type that does not fit does not compile (see the tests
/// of messages).
#[test]
fn sixteen_bits_are_not_read_as_thirty_two() {
    let statusword = c887::objects::statusword(c887::Axis::X);
    assert!(statusword.decode(&[0x37, 0x06, 0x00, 0x00]).is_err());
    assert_eq!(statusword.decode(&[0x37, 0x06]), Ok(c887::Statusword(0x0637)));
    assert_eq!(c887::RxPdo1600::unpack([0x0F, 0, 8, 1, 0, 0, 0]).target_position, 1);
}

/// A reset is given once for each wish, as an edge; the next fault wants its own.
#[test]
fn a_fault_reset_is_not_held() {
    for mut line in Line::all(State::SwitchOnDisabled) {
        for _ in 0..2 {
            line.axis.events = Events::FAULT;
            line.cycle();
            line.axis.events = Events::FAULT_REACTION_OVER;
            line.until(State::Fault);
            line.axis.events = Events::NONE;
            let resets = line.axis.rising(0x0080);
            (0..400).for_each(|_| _ = line.cycle());
            assert_eq!(
                (line.axis.state(), line.axis.rising(0x0080)),
                (State::Fault, resets),
                "{}",
                line.device
            );

            assert!(line.master.reset_fault());
            line.until(State::SwitchOnDisabled);
            (0..400).for_each(|_| _ = line.cycle());
            assert_eq!(line.axis.rising(0x0080), resets + 1, "{}", line.device);
            assert_eq!(line.axis.controlword() & 0x0080, 0, "{}", line.device);
        }
    }
}

/// A quick stop ends what was asked for: whatever made it, nobody moves until somebody asks again.
#[test]
fn no_drive_enables_itself_again_after_a_quick_stop() {
    for mut line in Line::all(State::SwitchOnDisabled) {
        line.master.request(Goal::OperationEnabled);
        line.until(State::OperationEnabled);
        line.master.quick_stop();
        line.until(State::QuickStopActive);
        line.stays_without_power();
    }
    // by its own hand: the drive stops, and its cause is gone at once
    for mut line in Line::all(State::SwitchOnDisabled) {
        line.master.request(Goal::OperationEnabled);
        line.until(State::OperationEnabled);
        line.axis.jump(State::QuickStopActive);
        line.stays_without_power();
    }
}

/// Nor after a fault, though the request for operation was never taken back.
#[test]
fn no_drive_enables_itself_again_after_a_fault() {
    for mut line in Line::all(State::SwitchOnDisabled) {
        line.master.request(Goal::OperationEnabled);
        line.until(State::OperationEnabled);
        line.axis.events = Events::FAULT | Events::FAULT_REACTION_OVER;
        line.until(State::Fault);
        line.axis.events = Events::NONE;
        line.stays_without_power();
        assert!(line.master.reset_fault());
        line.stays_without_power();
        assert_eq!(line.axis.state(), State::SwitchOnDisabled, "{}", line.device);
    }
}

/// The target is what the axis is at when it is enabled, not the 0 that a program begins with.
#[test]
fn no_axis_jumps_when_it_is_enabled() {
    for mut line in Line::all(State::SwitchOnDisabled) {
        line.axis.target = 0;
        line.master.request(Goal::OperationEnabled);
        line.until(State::OperationEnabled);
        (0..100).for_each(|_| _ = line.cycle());
        assert_eq!(line.axis.position, 5000, "{}", line.device);
    }
}

/// Process data count 1/100 000 mm, SDOs micrometres (C887T0011, p. 14): each has a unit of its own, and nothing wraps.
#[test]
fn micrometres_are_not_taken_for_millimetres() {
    let (in_pdo, in_sdo) = (c887::units::POSITION_MM, c887::units::SDO_LENGTH);
    let length = Length::micrometres(15);
    assert_eq!((in_pdo.exact::<i32>(length), in_sdo.exact::<i32>(length)), (Ok(1500), Ok(15)));
    assert_eq!(in_pdo.physical(1500_i32), in_sdo.physical(15_i32));
    assert_eq!(in_pdo.exact::<i32>(Length::metres(22)), Err(Unfit::OutOfRange));
}
