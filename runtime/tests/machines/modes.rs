//! Changes of the mode on the side of the drive, all numbers against the table of C887T0011, p. 11.

use devc_runtime::cia402::{ModeStep, ModeSwitch, Running, State};

use crate::device::{c887, pilz};

/// Displays `mode`, by the way that the device allows.
fn displaying(mode: i8) -> ModeSwitch {
    let mut switch = ModeSwitch::new(&c887::MACHINE.modes);
    switch.cycle(mode, State::OperationEnabled, Running::Over);
    assert_eq!(switch.display(), mode);
    switch
}

#[test]
fn the_c887_changes_its_mode_as_its_table_says() {
    for from in [0, 6, 8] {
        for asked in i8::MIN..=i8::MAX {
            let has = matches!(asked, 0 | 6 | 8);
            let mut switch = displaying(from);
            let step = switch.cycle(asked, State::OperationEnabled, Running::Over);
            let expected = match () {
                () if asked == from => (ModeStep::Steady, from),
                () if has => (ModeStep::Changed { from, to: asked }, asked),
                () => (ModeStep::Failed { asked }, 0),
            };
            assert_eq!((step, switch.display()), expected, "{from} to {asked}");
        }
    }
}

#[test]
fn what_runs_ends_first_and_its_failure_is_a_fault() {
    let mut switch = displaying(6);
    assert_eq!(switch.cycle(8, State::OperationEnabled, Running::Busy), ModeStep::Pending);
    assert_eq!(switch.display(), 6);
    assert_eq!(switch.cycle(8, State::OperationEnabled, Running::Failed), ModeStep::Failed { asked: 8 });
    assert_eq!(switch.display(), 0);
}

#[test]
fn the_c887_takes_a_mode_in_operation_enabled_only() {
    for state in State::ALL {
        let mut switch = ModeSwitch::new(&c887::MACHINE.modes);
        switch.cycle(8, state, Running::Over);
        assert_eq!(switch.display() == 8, state == State::OperationEnabled, "{state}");
    }
}

#[test]
fn a_mode_that_the_pilz_drive_has_not_is_never_displayed() {
    for asked in i8::MIN..=i8::MAX {
        let mut switch = ModeSwitch::new(&pilz::MACHINE.modes);
        switch.cycle(asked, State::SwitchedOn, Running::Over);
        let has = matches!(asked, -1..=4 | 6..=10);
        assert_eq!(switch.display(), if has { asked } else { 0 });
    }
}
