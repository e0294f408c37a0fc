//! Axes that share a state.

use super::{Coupling, Events, Machine, State, Step};

/// The state machines of the axes of one platform: transitions that all have to make, and transitions that one makes
/// for all (C887T0011, p. 10). Only the controlword of the first axis is taken, and all show the same state.
///
/// An axis that has made a transition which takes all of them waits for the others; the whole follows the last one.
///
/// ```
/// use devc_runtime::cia402::{Coupled, Coupling, Events, Machine, State, Transition, generic};
///
/// const TRANSITIONS: &[Transition] = &[
///     Transition { coupling: Coupling::All, ..generic::TRANSITIONS[2] },
///     Transition { coupling: Coupling::Any, ..generic::TRANSITIONS[7] },
/// ];
/// const MACHINE: Machine = Machine { transitions: TRANSITIONS, ..generic::MACHINE };
///
/// let mut axes = Coupled::<2>::resumed(&MACHINE, State::SwitchOnDisabled, 0);
/// axes.cycle(0x0006, [Events::NONE, Events::LOCKED_OUT]);
/// assert_eq!(axes.state(), State::SwitchOnDisabled);
/// axes.cycle(0x0006, [Events::NONE; 2]);
/// assert_eq!(axes.state(), State::ReadyToSwitchOn);
/// axes.cycle(0x0006, [Events::NONE, Events::LOCKED_OUT]);
/// assert_eq!(axes.state(), State::SwitchOnDisabled);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Coupled<const N: usize> {
    machine: &'static Machine,
    whole: State,
    axes: [State; N],
    controlword: u16,
}

impl<const N: usize> Coupled<N> {
    /// Just switched on, after transition 0.
    pub const fn new(machine: &'static Machine) -> Self {
        Self::resumed(machine, State::NotReadyToSwitchOn, u16::MAX)
    }

    /// All axes in that state, with that word received last.
    pub const fn resumed(machine: &'static Machine, state: State, controlword: u16) -> Self {
        Self { machine, whole: state, axes: [state; N], controlword }
    }

    /// The state of the whole, which every axis shows (C887T0011, p. 10).
    pub const fn state(&self) -> State {
        self.whole
    }

    /// The state of each axis, as far as it has come.
    pub const fn axes(&self) -> &[State; N] {
        &self.axes
    }

    /// One cycle: the controlword of the first axis, and what holds on each. The transition of the whole, if one was
    /// made.
    pub fn cycle(&mut self, controlword: u16, events: [Events; N]) -> Option<Step> {
        let words = (core::mem::replace(&mut self.controlword, controlword), controlword);
        let mut steps = [None; N];
        for ((step, state), events) in steps.iter_mut().zip(self.axes).zip(events) {
            *step = self.machine.step(state, words, events);
        }
        self.one_for_all(&steps).or_else(|| self.all_together(&steps))
    }

    /// The statusword of every axis: the bits of the state of the whole, all others as given.
    pub fn statusword(&self, other_bits: u16) -> u16 {
        self.machine.states.show(self.whole, other_bits)
    }

    /// A transition that one axis makes for all, which any is that does not take all. A fault goes before the rest.
    fn one_for_all(&mut self, steps: &[Option<Step>; N]) -> Option<Step> {
        let single = |step: &Step| self.coupling(step) != Coupling::All;
        let mut singles = steps.iter().flatten().filter(|step| single(step));
        let first = singles.clone().find(|step| step.number == 13).or_else(|| singles.next())?;
        let step = Step { from: self.whole, ..*first };
        (self.axes, self.whole) = ([step.to; N], step.to);
        Some(step)
    }

    /// Transitions that count once all axes have made them.
    fn all_together(&mut self, steps: &[Option<Step>; N]) -> Option<Step> {
        let mut last = None;
        for (state, step) in self.axes.iter_mut().zip(steps) {
            // who is ahead of the whole waits
            if let Some(step) = step.filter(|step| step.from == self.whole) {
                *state = step.to;
                last = Some(step);
            }
        }
        let step = last?;
        self.axes.iter().all(|state| *state == step.to).then(|| {
            self.whole = step.to;
            step
        })
    }

    fn coupling(&self, step: &Step) -> Coupling {
        self.machine.transition(step.number).map_or(Coupling::Any, |transition| transition.coupling)
    }
}
