//! An axis that is as quick as it can be: it answers in the cycle after.

use devc_runtime::cia402::{Drive, Events, Machine, ModeSwitch, Running, State, Step};

pub(crate) struct Axis {
    drive: Drive,
    machine: &'static Machine,
    mode: ModeSwitch,
    /// What holds in the drive.
    pub(crate) events: Events,
    pub(crate) target: i32,
    pub(crate) position: i32,
    /// The controlwords that came.
    words: Vec<u16>,
}

impl Axis {
    /// In that state, at position 5000.
    pub(crate) fn new(machine: &'static Machine, state: State) -> Self {
        Self {
            drive: Drive::new(machine).resumed(state, 0),
            machine,
            mode: ModeSwitch::new(&machine.modes),
            events: Events::NONE,
            target: 0,
            position: 5000,
            words: vec![0],
        }
    }

    pub(crate) fn state(&self) -> State {
        self.drive.state()
    }

    pub(crate) fn statusword(&self) -> u16 {
        self.drive.statusword(0)
    }

    pub(crate) fn mode(&self) -> i8 {
        self.mode.display()
    }

    /// The controlword that came last.
    pub(crate) fn controlword(&self) -> u16 {
        self.words.last().copied().unwrap_or(0)
    }

    /// Goes to a state by its own means.
    pub(crate) fn jump(&mut self, state: State) {
        self.drive = Drive::new(self.machine).resumed(state, self.controlword());
    }

    pub(crate) fn cycle(&mut self, controlword: u16, mode: i8) -> Option<Step> {
        self.words.push(controlword);
        let step = self.drive.cycle(controlword, self.events);
        self.mode.cycle(mode, self.state(), Running::Over);
        if self.state() == State::OperationEnabled {
            self.position = self.target;
        }
        step
    }

    /// How often a bit has risen.
    pub(crate) fn rising(&self, mask: u16) -> usize {
        self.words
            .windows(2)
            .filter(|pair| matches!(pair, [before, now] if !before & now & mask != 0))
            .count()
    }
}
