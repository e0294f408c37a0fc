//! The state machine of one axis, on the side of the master.

mod aim;
mod frame;
mod progress;
mod route;
mod sender;

pub use aim::Goal;
pub use frame::{Feedback, Output, Timing};
pub use progress::{Awaited, Progress, Waiting, Withdrawal};
pub use route::Leave;

use aim::Aim;
use route::Road;
use sender::Sender;

use super::{Command, Machine, Observer, State, Transition, UnknownMode};

/// What a control program runs for an axis: from any state towards a goal, one controlword each cycle (CiA 402, PDS
/// FSA, from the side of the control device).
///
/// - Nothing happens without a request. A request ends when the drive leaves the way to its goal, by a fault, a quick
///   stop or a signal: the drive is then never enabled again until the next request.
/// - Without a goal, a drive in operation enabled is led out of it; any other state is kept.
/// - A fault reset is an edge, and given only after [`reset_fault`](Self::reset_fault).
/// - The drive is enabled once the caller has set targets to actual values ([`Output::seed`]), and may be moved once
///   the mode is displayed ([`Output::motion`]).
/// - What does not come in time ends the request too, and says what it was ([`Progress::Overdue`]).
///
/// Where axes share a state (C887T0011, p. 12), one master leads all of them by the statusword of the first; its
/// controlword goes to each.
///
/// ```
/// use devc_runtime::cia402::{Drive, Events, Feedback, Goal, Master, Progress, State, generic};
///
/// let mut drive = Drive::new(&generic::MACHINE);
/// let mut master = Master::new(&generic::MACHINE);
/// master.request(Goal::OperationEnabled);
///
/// let mut seeded = false;
/// for _ in 0..10 {
///     let output = master.cycle(Feedback { statusword: drive.statusword(0), mode: 0, seeded });
///     seeded = output.seed; // and target = actual
///     drive.cycle(output.controlword, Events::INITIALISED);
/// }
/// assert_eq!(drive.state(), State::OperationEnabled);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Master {
    machine: &'static Machine,
    timing: Timing,
    leave: Leave,
    observer: Observer,
    sender: Sender,
    state: Option<State>,
    aim: Aim,
    /// Transitions left, as of the last cycle.
    left: Option<u8>,
    mode: Option<i8>,
    /// Whether the caller was allowed to move the drive in the last cycle.
    motion: bool,
    waiting: Option<Waiting>,
    waited: u16,
    /// What the last request came to.
    outcome: Progress,
}

impl Master {
    /// Idle, with the timing of [`Timing::DEFAULT`].
    pub const fn new(machine: &'static Machine) -> Self {
        Self {
            machine,
            timing: Timing::DEFAULT,
            leave: Leave::DisableOperation,
            observer: Observer::new(machine),
            sender: Sender::new(),
            state: None,
            aim: Aim::Rest,
            left: None,
            mode: None,
            motion: false,
            waiting: None,
            waited: 0,
            outcome: Progress::Idle,
        }
    }

    /// With that timing.
    #[must_use]
    pub const fn timing(self, timing: Timing) -> Self {
        Self { timing, ..self }
    }

    /// With that way out of operation enabled.
    #[must_use]
    pub const fn leaving_by(self, leave: Leave) -> Self {
        Self { leave, ..self }
    }

    /// The state that the drive showed last.
    pub const fn state(&self) -> Option<State> {
        self.state
    }

    /// Asks for a state. Replaces any other request; the same one again changes nothing while it lasts.
    ///
    /// A request is somebody's wish, to be made when it is wished: one that a program repeats each cycle would enable a
    /// drive again after each fault.
    pub fn request(&mut self, goal: Goal) {
        self.ask(Aim::Goal(goal));
    }

    /// Asks for a quick stop (transition 11). Replaces any other request; a drive that is not enabled stays where it
    /// is.
    pub fn quick_stop(&mut self) {
        self.ask(Aim::QuickStop);
    }

    /// Asks for a fault reset (transition 15); `false` if the drive shows no fault, and nothing is asked for.
    ///
    /// It ends in switch on disabled, and leads nowhere further.
    pub fn reset_fault(&mut self) -> bool {
        let is_fault = matches!(self.state, Some(State::Fault | State::FaultReactionActive));
        if is_fault {
            self.ask(Aim::FaultReset);
        }
        is_fault
    }

    /// Asks for a mode of operation, with the drive at rest; there is no motion until the drive displays it.
    ///
    /// # Errors
    ///
    /// The device does not have the mode.
    pub fn select(&mut self, mode: i8) -> Result<(), UnknownMode> {
        if !self.machine.modes.has(mode) {
            return Err(UnknownMode(mode));
        }
        self.mode = Some(mode);
        Ok(())
    }

    /// One cycle: from what came last, what is to be sent. If nothing came, the last feedback is to be given again.
    pub fn cycle(&mut self, feedback: Feedback) -> Output {
        let Ok(state) = self.observer.observe(feedback.statusword) else {
            return self.without_state(feedback);
        };
        self.judge(state);
        let (command, awaits) = self.decide(state, feedback);
        let (road, timing) = (self.road(), self.timing);
        let controlword = self.sender.send(&road, timing, state, command);
        let progress = self.watch(awaits);
        self.motion = self.aim.is_operation() && progress == Progress::Reached;
        self.output(controlword, progress, feedback)
    }

    fn ask(&mut self, aim: Aim) {
        if self.aim != aim {
            self.pursue(aim);
        }
    }

    const fn pursue(&mut self, aim: Aim) {
        self.aim = aim;
        self.left = None;
        self.waiting = None;
        self.waited = 0;
        self.sender.restart();
    }

    fn give_up(&mut self, outcome: Progress) {
        self.pursue(Aim::Rest);
        self.outcome = outcome;
    }

    const fn road(&self) -> Road {
        let fault_reset = matches!(self.aim, Aim::FaultReset);
        Road { machine: self.machine, leave: self.leave, fault_reset }
    }

    /// Ends the request if the drive has left the way.
    fn judge(&mut self, state: State) {
        let before = self.state.replace(state);
        let Some(target) = self.aim.target() else { return };
        let left = self.road().leg(state, target).map(|leg| leg.left);
        // a quick stop that was there when the request came may end
        let has_ended = before == Some(State::QuickStopActive) && state == State::SwitchOnDisabled;
        let is_further = left.is_none() || !has_ended && self.left.is_some_and(|before| left > Some(before));
        // a state that enable operation may lead out of (transition 16), but never by itself
        let is_stopped = self.aim.is_operation()
            && state == State::QuickStopActive
            && before.is_some_and(|before| before != state);
        self.left = left;
        if is_further || is_stopped {
            let goal = self.aim.goal();
            let from = before.unwrap_or(state);
            self.give_up(Progress::Withdrawn(Withdrawal { goal, from, to: state }));
        }
    }

    /// The next command, and what has to come before all is as requested.
    fn decide(&self, state: State, feedback: Feedback) -> (Option<&'static Command>, Option<Awaited>) {
        let next = self.next(state);
        let operates = next.map_or(state, |next| next.to) == State::OperationEnabled;
        if self.aim.is_operation()
            && operates
            && let Some(missing) = self.missing(state, feedback)
        {
            return (None, Some(missing));
        }
        let Some(next) = next else { return (None, None) };
        match self.road().command(next, state) {
            Some(command) => {
                (Some(command), Some(Awaited::Transition { number: next.number, command: command.name }))
            }
            None => (None, Some(Awaited::Automatic { number: next.number })),
        }
    }

    fn next(&self, state: State) -> Option<&'static Transition> {
        let towards = |target| self.road().leg(state, target).and_then(|leg| leg.next);
        let quick_stop = || self.machine.transition(11).filter(|_| self.aim == Aim::QuickStop);
        match self.aim.target() {
            Some(target) => towards(target),
            None if state == State::OperationEnabled => quick_stop().or_else(|| towards(State::SwitchedOn)),
            None => None,
        }
    }

    /// What is missing for operation: the mode as soon as the device takes one, and targets at actual values.
    fn missing(&self, state: State, feedback: Feedback) -> Option<Awaited> {
        let displayed = feedback.mode;
        let is_due = state == State::OperationEnabled || self.machine.modes.are_selectable_in(state);
        match self.mode {
            Some(asked) if asked != displayed && is_due => Some(Awaited::Mode { asked, displayed }),
            _ => (!self.motion && !feedback.seeded).then_some(Awaited::Seed),
        }
    }

    /// Counts the cycles of a wait, and ends the request when they are too many.
    fn watch(&mut self, awaits: Option<Awaited>) -> Progress {
        if self.aim == Aim::Rest {
            return self.outcome;
        }
        let Some(awaits) = awaits else {
            self.waiting = None;
            self.outcome = Progress::Reached;
            return self.outcome;
        };
        let waiting = Waiting { state: self.state, awaits };
        let is_same = self.waiting.is_some_and(|before| before.is_like(&waiting));
        self.waited = if is_same { self.waited.saturating_add(1) } else { 0 };
        self.waiting = Some(waiting);
        self.outcome = Progress::Waiting(waiting);
        if self.waited >= self.timing.timeout {
            self.give_up(Progress::Overdue(waiting));
        }
        self.outcome
    }

    /// A statusword that shows no state: nothing new is sent, soon there is no motion, in the end no power.
    fn without_state(&mut self, feedback: Feedback) -> Output {
        let progress = self.watch(Some(Awaited::State { statusword: feedback.statusword }));
        // a few of them are as frames that are lost; a target that were set now would make a drive jerk
        self.motion &= self.waited < self.timing.round_trip;
        let is_over = matches!(progress, Progress::Overdue(Waiting { awaits: Awaited::State { .. }, .. }));
        let power_off = is_over.then(|| self.road().holding(State::SwitchOnDisabled));
        let controlword = self.sender.send_unseen(power_off);
        self.output(controlword, progress, feedback)
    }

    fn output(&self, controlword: u16, progress: Progress, feedback: Feedback) -> Output {
        let mode = self.mode.unwrap_or(feedback.mode);
        Output { controlword, mode, seed: !self.motion, motion: self.motion, progress }
    }
}
