//! The EtherCAT state machine of a device, against the table of ETG.1000.6, "state machine".

use devc_runtime::esm::{
    AlControl, AlState, AlStatusCode, Application, Area, Areas, Change, Configured, Manager, Role,
    StateMachine, Watchdog,
};
use devc_runtime::sdo::CommunicationState;

use AlState::{Bootstrap, Init, Operational, PreOperational, SafeOperational};

const AREAS: Areas = Areas {
    managers: &[
        Manager::new(Role::MailboxOut, 0x1000, (16, 128)),
        Manager::new(Role::MailboxIn, 0x1080, (16, 128)),
        Manager::new(Role::Outputs, 0x1100, (0, 64)),
        Manager::new(Role::Inputs, 0x1400, (0, 64)),
    ],
    boot: Some([Area { address: 0x1000, length: (16, 512) }, Area { address: 0x1200, length: (16, 512) }]),
};

/// Bytes of process data, by the number of the sync manager.
const LENGTHS: [usize; 4] = [0, 0, 6, 8];

const fn on(address: u16, length: u16, control: u8) -> Configured {
    Configured { address, length, control, is_on: true }
}

const MANAGERS: [Configured; 4] =
    [on(0x1000, 128, 0x26), on(0x1080, 128, 0x22), on(0x1100, 6, 0x64), on(0x1400, 8, 0x20)];
const BOOT: [Configured; 4] =
    [on(0x1000, 512, 0x26), on(0x1200, 512, 0x22), on(0x1100, 6, 0x64), on(0x1400, 8, 0x20)];

fn request(machine: &mut StateMachine, to: AlState) -> AlStatusCode {
    let managers = if to == Bootstrap { BOOT } else { MANAGERS };
    machine.request(AlControl::request(to, false), &managers, &LENGTHS, &mut ());
    machine.code()
}

/// A machine that was led to a state.
fn at(state: AlState) -> StateMachine {
    let mut machine = StateMachine::new(AREAS);
    let path: &[AlState] = match state {
        Init => &[],
        Bootstrap => &[Bootstrap],
        PreOperational => &[PreOperational],
        SafeOperational => &[PreOperational, SafeOperational],
        Operational => &[PreOperational, SafeOperational, Operational],
    };
    for to in path {
        assert_eq!(request(&mut machine, *to), AlStatusCode::NONE);
    }
    assert_eq!(machine.state(), state);
    machine
}

/// IP, PI, IB, BI, PS, SP, SI, SO, OS, OP, OI; all else is an invalid requested state change, 0x0011.
#[test]
fn only_the_changes_of_the_standard_are_made() {
    let allowed = [
        (Init, PreOperational),
        (PreOperational, Init),
        (Init, Bootstrap),
        (Bootstrap, Init),
        (PreOperational, SafeOperational),
        (SafeOperational, PreOperational),
        (SafeOperational, Init),
        (SafeOperational, Operational),
        (Operational, SafeOperational),
        (Operational, PreOperational),
        (Operational, Init),
    ];
    let states = [Init, PreOperational, Bootstrap, SafeOperational, Operational];
    for from in states {
        for to in states {
            let mut machine = at(from);
            let code = request(&mut machine, to);
            let is_allowed = from == to || allowed.contains(&(from, to));
            let expected = if is_allowed { (to, 0x0000) } else { (from, 0x0011) };
            assert_eq!((machine.state(), code.0), expected, "{from:?} to {to:?}");
            assert_eq!(machine.status().0 & 0x10 != 0, !is_allowed, "{from:?} to {to:?}");
        }
    }
}

#[test]
fn states_that_there_are_not_are_told_apart() {
    let mut machine = at(Init);
    for number in [0, 5, 6, 7, 9, 15] {
        machine.request(AlControl(number), &MANAGERS, &LENGTHS, &mut ());
        assert_eq!((machine.state(), machine.code().0), (Init, 0x0012), "{number}");
    }
    let mut machine = StateMachine::new(Areas { boot: None, ..AREAS });
    assert_eq!(request(&mut machine, Bootstrap).0, 0x0013);
}

/// Each setting that is wrong, with the change that sees it and its code.
#[test]
fn sync_managers_are_judged_at_their_change() {
    let with = |number: usize, setting: Configured| {
        let mut managers = MANAGERS;
        managers[number] = setting;
        managers
    };
    let off = |setting: Configured| Configured { is_on: false, ..setting };
    let cases = [
        (Init, PreOperational, with(0, off(MANAGERS[0])), 0x0016),
        (Init, PreOperational, with(0, on(0x1010, 128, 0x26)), 0x0016),
        (Init, PreOperational, with(0, on(0x1000, 8, 0x26)), 0x0016),
        (Init, PreOperational, with(0, on(0x1000, 256, 0x26)), 0x0016),
        (Init, PreOperational, with(0, on(0x1000, 128, 0x22)), 0x0016),
        (Init, PreOperational, with(0, on(0x1000, 128, 0x24)), 0x0016),
        (Init, PreOperational, with(1, off(MANAGERS[1])), 0x0016),
        (Init, PreOperational, with(1, on(0x1080, 128, 0x26)), 0x0016),
        (Init, Bootstrap, MANAGERS, 0x0015),
        (PreOperational, SafeOperational, with(2, off(MANAGERS[2])), 0x001D),
        (PreOperational, SafeOperational, with(2, on(0x1100, 5, 0x64)), 0x001D),
        (PreOperational, SafeOperational, with(2, on(0x1100, 7, 0x64)), 0x001D),
        (PreOperational, SafeOperational, with(2, on(0x1108, 6, 0x64)), 0x001D),
        (PreOperational, SafeOperational, with(2, on(0x1100, 6, 0x60)), 0x001D),
        (PreOperational, SafeOperational, with(2, on(0x1100, 6, 0x66)), 0x001D),
        (PreOperational, SafeOperational, with(3, off(MANAGERS[3])), 0x001E),
        (PreOperational, SafeOperational, with(3, on(0x1400, 6, 0x20)), 0x001E),
        (PreOperational, SafeOperational, with(3, on(0x1400, 8, 0x24)), 0x001E),
    ];
    for (from, to, managers, code) in cases {
        let mut machine = at(from);
        machine.request(AlControl::request(to, false), &managers, &LENGTHS, &mut ());
        assert_eq!((machine.state(), machine.code().0), (from, code), "{to:?} with {managers:?}");
    }
}

#[test]
fn what_nothing_is_mapped_to_is_off() {
    for (is_on, code) in [(false, 0x0000), (true, 0x001D)] {
        let mut machine = at(PreOperational);
        let mut managers = MANAGERS;
        managers[2].is_on = is_on;
        machine.request(AlControl(0x04), &managers, &[0, 0, 0, 8], &mut ());
        assert_eq!(machine.code().0, code);
    }
}

/// Two sync managers from the master, and two to it, the second before the first of the other direction: each has to be as long
/// as what is mapped to it, and the one that is wrong gives the code of its direction.
#[test]
fn each_sync_manager_of_a_direction_is_judged() {
    const FOUR: Areas = Areas {
        managers: &[
            Manager::new(Role::Outputs, 0x1100, (0, 16)),
            Manager::new(Role::Inputs, 0x1200, (0, 16)),
            Manager::new(Role::Outputs, 0x1300, (0, 16)),
            Manager::new(Role::Inputs, 0x1400, (0, 16)),
        ],
        boot: None,
    };
    let right = [on(0x1100, 6, 0x64), on(0x1200, 8, 0x20), on(0x1300, 2, 0x24), on(0x1400, 4, 0x20)];
    let code = |managers: [Configured; 4], lengths: [usize; 4]| {
        let mut machine = StateMachine::new(FOUR);
        machine.request(AlControl(0x02), &managers, &lengths, &mut ());
        machine.request(AlControl(0x04), &managers, &lengths, &mut ());
        machine.code().0
    };
    assert_eq!(code(right, [6, 8, 2, 4]), 0);
    for (number, expected) in [(0, 0x001D), (1, 0x001E), (2, 0x001D), (3, 0x001E)] {
        let mut managers = right;
        managers[number].length += 1;
        assert_eq!(code(managers, [6, 8, 2, 4]), expected, "{number} is too long");
        managers[number] = Configured { is_on: false, ..right[number] };
        assert_eq!(code(managers, [6, 8, 2, 4]), expected, "{number} is off");
        let mut lengths = [6, 8, 2, 4];
        lengths[number] = 0;
        assert_eq!(code(managers, lengths), 0, "nothing is mapped to {number}");
    }
}

#[test]
fn an_error_is_shown_until_it_is_acknowledged() {
    let mut machine = at(PreOperational);
    assert_eq!(request(&mut machine, Operational).0, 0x0011);
    assert_eq!(machine.status().0, 0x12);
    // a way up is not taken before
    assert_eq!(request(&mut machine, SafeOperational).0, 0x0011);
    assert_eq!(machine.status().0, 0x12);
    machine.request(AlControl(0x12), &MANAGERS, &LENGTHS, &mut ());
    assert_eq!((machine.status().0, machine.code().0), (0x02, 0));
    // and both at once
    assert_eq!(request(&mut machine, Operational).0, 0x0011);
    machine.request(AlControl(0x14), &MANAGERS, &LENGTHS, &mut ());
    assert_eq!((machine.status().0, machine.code().0), (0x04, 0));
}

#[test]
fn outputs_that_do_not_come_in_time_take_it_out_of_operational() {
    let mut machine = at(Operational);
    let mut watchdog = Watchdog::new(100_000_000);
    for _ in 0..99 {
        assert!(!watchdog.elapse(1_000_000));
    }
    watchdog.feed();
    assert!(!watchdog.elapse(99_000_000));
    assert!(watchdog.elapse(1_000_000));
    let change = Change { from: Operational, to: SafeOperational };
    assert_eq!(machine.watchdog_expired(), Some(change));
    assert_eq!((machine.status().0, machine.code().0), (0x14, 0x001B));
    assert_eq!(machine.watchdog_expired(), None, "there are no outputs any more");
    // a way down needs no acknowledgement, and the error stays
    assert_eq!(request(&mut machine, PreOperational).0, 0x001B);
    assert_eq!(machine.status().0, 0x12);
    assert!(!Watchdog::new(0).elapse(u64::MAX), "it is off");
}

/// A firmware that refuses what it is told to.
struct Firmware {
    refuses: AlStatusCode,
    has_outputs: bool,
    told: Vec<Change>,
}

impl Application for Firmware {
    fn before(&mut self, change: Change) -> Result<(), AlStatusCode> {
        self.told.push(change);
        if self.refuses == AlStatusCode::NONE { Ok(()) } else { Err(self.refuses) }
    }

    fn has_outputs(&self) -> bool {
        self.has_outputs
    }
}

#[test]
fn the_firmware_has_a_say_on_the_way_up() {
    let mut firmware =
        Firmware { refuses: AlStatusCode::INVALID_CYCLE, has_outputs: false, told: Vec::new() };
    let mut machine = at(PreOperational);
    machine.request(AlControl(0x04), &MANAGERS, &LENGTHS, &mut firmware);
    assert_eq!((machine.status().0, machine.code().0), (0x12, 0x0035));
    let mut machine = at(SafeOperational);
    machine.request(AlControl(0x08), &MANAGERS, &LENGTHS, &mut firmware);
    assert_eq!((machine.status().0, machine.code().0), (0x14, 0x0019));
    // down it goes whatever the firmware says
    let mut machine = at(Operational);
    machine.request(AlControl(0x01), &MANAGERS, &LENGTHS, &mut firmware);
    assert_eq!((machine.state(), machine.code().0), (Init, 0x0035));
    let told = [(PreOperational, SafeOperational), (Operational, Init)];
    assert_eq!(firmware.told, told.map(|(from, to)| Change { from, to }));
}

/// ETG.1000.6, AL status code 0x001F: a watchdog of no time cannot watch outputs. Bit 6 of the control byte says that it does
/// (ETG.1000.4, sync manager).
#[test]
fn outputs_are_watched_if_their_sync_manager_says_so() {
    struct Timeless;
    impl Application for Timeless {
        fn watchdog(&self) -> Option<Watchdog> {
            Some(Watchdog::new(0))
        }
    }
    let led = |control: u8, is_on: bool| {
        let mut managers = MANAGERS;
        managers[2] = Configured { is_on, ..on(0x1100, 6, control) };
        let mut machine = at(PreOperational);
        let lengths = if is_on { LENGTHS } else { [0, 0, 0, 8] };
        machine.request(AlControl(0x04), &managers, &lengths, &mut Timeless);
        machine.code().0
    };
    assert_eq!(led(0x64, true), 0x001F);
    assert_eq!(led(0x24, true), 0);
    assert_eq!(led(0x64, false), 0, "what is off is not watched");
}

/// Outputs that are not there cannot be missing.
#[test]
fn a_device_without_outputs_needs_none_to_be_operational() {
    let mut firmware = Firmware { refuses: AlStatusCode::NONE, has_outputs: false, told: Vec::new() };
    let mut machine = at(SafeOperational);
    machine.request(AlControl(0x08), &MANAGERS, &[0, 0, 0, 8], &mut firmware);
    assert_eq!((machine.state(), machine.code().0), (Operational, 0));
}

#[test]
fn signals_that_stay_away_take_it_out_of_operational() {
    let mut machine = at(Operational);
    let change = Change { from: Operational, to: SafeOperational };
    assert_eq!(machine.signals_lost(), Some(change));
    assert_eq!((machine.status().0, machine.code().0), (0x14, 0x002C));
    assert_eq!(machine.signals_lost(), None);
}

#[test]
fn the_mailbox_is_served_where_there_is_one() {
    use CommunicationState as C;
    let expected = [
        (Init, None),
        (Bootstrap, None),
        (PreOperational, Some(C::PreOperational)),
        (SafeOperational, Some(C::SafeOperational)),
        (Operational, Some(C::Operational)),
    ];
    for (state, communication) in expected {
        assert_eq!(at(state).communication(), communication);
    }
}
