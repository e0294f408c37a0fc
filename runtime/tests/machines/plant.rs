//! A drive with a position, and a line to it that loses, delays and repeats frames: the same for the same seed.

use std::collections::VecDeque;

use devc_runtime::cia402::{
    Cause, Drive, Events, Feedback, Machine, ModeSwitch, Output, Running, State, Step,
};

/// What the master sends in a cycle.
#[derive(Clone, Copy)]
pub(crate) struct Command {
    pub(crate) controlword: u16,
    pub(crate) mode: i8,
    pub(crate) target: i32,
}

/// What the drive sends in a cycle.
#[derive(Clone, Copy)]
pub(crate) struct Report {
    pub(crate) statusword: u16,
    pub(crate) mode: i8,
    pub(crate) position: i32,
}

/// Numbers that look random (xorshift, Marsaglia).
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub(crate) fn below(&mut self, end: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % end
    }
}

/// One direction of the line. Frames come in the order in which they were sent, up to three cycles late; up to three
/// in a row are lost; where none comes, the last is there again.
pub(crate) struct Line<T> {
    frames: VecDeque<(u64, T)>,
    last: T,
    lost: u64,
    now: u64,
}

impl<T: Copy> Line<T> {
    pub(crate) fn new(last: T) -> Self {
        Self { frames: VecDeque::new(), last, lost: 0, now: 0 }
    }

    pub(crate) fn carry(&mut self, frame: T, dice: Option<&mut Dice>) -> T {
        self.now += 1;
        let Some(dice) = dice else {
            self.last = frame;
            return frame;
        };
        if self.lost < 3 && dice.below(3) == 0 {
            self.lost += 1;
        } else {
            self.lost = 0;
            self.frames.push_back((self.now + dice.below(4), frame));
        }
        while let Some((due, frame)) = self.frames.front().copied()
            && due <= self.now
        {
            self.last = frame;
            self.frames.pop_front();
        }
        self.last
    }
}

/// Cycles from a word to its answer, at the most: losses, delays and a cycle each way.
pub(crate) const ROUND_TRIP: u16 = 16;

/// The position at first.
const START: i32 = 1000;

/// The word that a drive in that state has, if it came there in good order.
fn left_by_another_master(state: State) -> u16 {
    match state {
        State::ReadyToSwitchOn => 0x0006,
        State::SwitchedOn => 0x0007,
        State::OperationEnabled => 0x000F,
        State::QuickStopActive => 0x000B,
        _ => 0x0000,
    }
}

pub(crate) struct Plant {
    pub(crate) drive: Drive,
    pub(crate) mode: ModeSwitch,
    pub(crate) position: i32,
    pub(crate) made: Vec<Step>,
    pub(crate) events: Events,
    down: Line<Command>,
    up: Line<Report>,
    dice: Option<Dice>,
    /// What the control program keeps as its target.
    target: i32,
    pub(crate) seeds: bool,
    seeded: bool,
    pub(crate) sent: Vec<u16>,
}

impl Plant {
    /// A drive in a state, over a line that is perfect without a seed.
    pub(crate) fn new(machine: &'static Machine, state: State, seed: Option<u64>) -> Self {
        let controlword = left_by_another_master(state);
        let target = if state == State::OperationEnabled { START } else { 0 };
        let drive = Drive::new(machine).resumed(state, controlword);
        let mode = ModeSwitch::new(&machine.modes);
        let report = Report { statusword: drive.statusword(0), mode: 0, position: START };
        Self {
            drive,
            mode,
            position: START,
            made: Vec::new(),
            events: Events::INITIALISED | Events::FAULT_REACTION_OVER,
            down: Line::new(Command { controlword, mode: 0, target }),
            up: Line::new(report),
            dice: seed.map(Dice::new),
            target,
            seeds: true,
            seeded: false,
            sent: vec![controlword],
        }
    }

    /// What the master gets in this cycle.
    pub(crate) fn feedback(&mut self) -> Feedback {
        let report = Report {
            statusword: self.drive.statusword(0),
            mode: self.mode.display(),
            position: self.position,
        };
        let report = self.up.carry(report, self.dice.as_mut());
        if self.seeded {
            self.target = report.position;
        }
        Feedback { statusword: report.statusword, mode: report.mode, seeded: self.seeded }
    }

    /// What the drive does with what the master sends.
    pub(crate) fn run(&mut self, output: &Output) -> Option<Step> {
        assert!(output.seed != output.motion);
        self.seeded = output.seed && self.seeds;
        self.sent.push(output.controlword);
        let command = Command { controlword: output.controlword, mode: output.mode, target: self.target };
        let command = self.down.carry(command, self.dice.as_mut());
        let step = self.drive.cycle(command.controlword, self.events);
        self.made.extend(step);
        self.mode.cycle(command.mode, self.drive.state(), Running::Over);
        if self.drive.state() == State::OperationEnabled {
            let jump = (command.target - self.position).abs();
            // what gravity does while word and answer are under way
            assert!(jump <= i32::from(ROUND_TRIP), "jumps by {jump}");
            self.position = command.target;
        } else {
            // gravity pulls
            self.position -= 1;
        }
        step
    }

    /// The word that was sent last.
    pub(crate) fn word(&self) -> u16 {
        self.sent.last().copied().unwrap_or_default()
    }

    /// Whether the drive took a word for a mistake.
    pub(crate) fn refused(&self) -> Option<&Step> {
        self.made.iter().find(|step| matches!(step.cause, Cause::Refused { .. }))
    }

    pub(crate) fn rising(&self, bit: u16) -> usize {
        self.sent
            .iter()
            .zip(self.sent.iter().skip(1))
            .filter(|(before, after)| !*before & *after & bit != 0)
            .count()
    }
}
