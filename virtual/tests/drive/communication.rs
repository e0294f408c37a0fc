//! The EtherCAT states, with what a master may have set wrongly (ETG.1000.6, EtherCAT state machine).

use devc::model::{Address, Index, Role};
use devc_runtime::esm::{AlState, AlStatusCode, Configured};
use devc_runtime::sdo::AbortCode;
use devc_virtual::Firmware;

use crate::bench::{Bench, INIT, OP, PRE_OP, SAFE_OP, device, devices};

#[test]
fn every_configuration_leads_to_operational() {
    for device in devices() {
        for chosen in &device.configurations {
            let mut bench = Bench::new(device, Some(chosen));
            bench.start(Some(chosen));
            let (_, lengths) = bench.drive.expected();
            let carried = [0, 0, bench.outputs.bytes(), bench.inputs.bytes()];
            assert_eq!(lengths[..4], carried, "{}, {}", device.name, chosen.name);
        }
    }
}

#[test]
fn mailboxes_have_to_be_where_they_are() {
    for device in devices() {
        let mut bench = Bench::new(device, None);
        let right = bench.managers();
        let change: [fn(&mut Configured); 4] =
            [|it| it.is_on = false, |it| it.address += 2, |it| it.length += 1, |it| it.control ^= 0x04];
        for number in [0, 1] {
            for change in change {
                let mut managers = right;
                change(&mut managers[number]);
                let refused = bench.request_with(PRE_OP, &managers);
                assert_eq!(refused, Err(AlStatusCode::INVALID_MAILBOX), "{}, {number}", device.name);
            }
        }
        assert_eq!(bench.request(PRE_OP), Ok(()));
    }
}

#[test]
fn process_data_has_to_be_as_long_as_what_is_mapped() {
    for device in devices() {
        let mut bench = Bench::new(device, None);
        bench.request(PRE_OP).expect("nothing is wrong");
        let right = bench.managers();
        for (number, code) in [(2, AlStatusCode::INVALID_OUTPUTS), (3, AlStatusCode::INVALID_INPUTS)] {
            for by in [-1, 1] {
                let mut managers = right;
                managers[number].length = managers[number].length.wrapping_add_signed(by);
                assert_eq!(bench.request_with(SAFE_OP, &managers), Err(code), "{}, {by}", device.name);
            }
        }
        assert_eq!(bench.request(SAFE_OP), Ok(()));
        assert_eq!(bench.request(OP), Err(AlStatusCode::NO_VALID_OUTPUTS), "{}", device.name);
        bench.cycle();
        assert_eq!(bench.request(OP), Ok(()));
    }
}

#[test]
fn a_master_that_falls_silent_stops_the_drive() {
    for device in devices() {
        let mut bench = Bench::operational(device);
        bench.enable();
        bench.drive.watchdog_expired();
        let (status, code) = bench.drive.status();
        assert_eq!((status.0, code), (0x14, AlStatusCode::WATCHDOG), "{}", device.name);
        bench.cycles(20);
        bench.all_show("fault");
        let said = bench.emergencies();
        assert!(said.iter().all(|(code, _)| [0x8100, 0x7500].contains(code)) && !said.is_empty(), "{said:?}");
        // the master comes again; outputs that came before do not count
        assert_eq!(bench.request(SAFE_OP), Ok(()));
        bench.request(OP).expect("outputs came since");
    }
}

#[test]
fn a_mailbox_is_there_from_pre_operational_on() {
    let device = device("c887");
    let mut bench = Bench::new(device, None);
    let message = [10, 0, 0, 0, 0, 0x13, 0, 0x20, 0x40, 0x00, 0x10, 0, 0, 0, 0, 0];
    assert_eq!(bench.drive.mail(&message, &mut [0; 128]), 0);
    bench.request(PRE_OP).expect("nothing is wrong");
    assert_eq!(bench.drive.mail(&message, &mut [0; 128]), 16);
    bench.request(INIT).expect("a way down");
    assert_eq!(bench.drive.mail(&message, &mut [0; 128]), 0);
    // a master begins to count anew
    bench.request(PRE_OP).expect("nothing is wrong");
    assert_eq!(bench.drive.mail(&message, &mut [0; 128]), 16);
}

#[test]
fn outputs_move_nothing_before_operational() {
    let device = device("c887");
    let mut bench = Bench::new(device, None);
    bench.request(PRE_OP).expect("nothing is wrong");
    bench.request(SAFE_OP).expect("nothing is wrong");
    bench.command(0x06);
    bench.all_show("switch-on-disabled");
    bench.request(OP).expect("outputs came");
    bench.cycle();
    bench.all_show("ready-to-switch-on");
}

/// A device whose EEPROM has no mailbox for it does not have the state (ETG.1000.6, 0x0013).
#[test]
fn bootstrap_is_there_where_the_eeprom_has_a_mailbox_for_it() {
    const BOOTSTRAP: AlState = AlState::Bootstrap;
    for device in devices() {
        assert_eq!(
            Bench::new(device, None).request(BOOTSTRAP),
            Err(AlStatusCode::NO_BOOTSTRAP),
            "{}",
            device.name
        );
    }
    let mut bench = Bench::new(device("own"), None);
    let mailbox = |address, length, control| Configured { address, length, control, is_on: true };
    let mut managers = [Configured::default(); 4];
    [managers[0], managers[1]] = [mailbox(0x1000, 256, 0x26), mailbox(0x1100, 256, 0x22)];
    assert_eq!(
        bench.request(BOOTSTRAP),
        Err(AlStatusCode::INVALID_BOOT_MAILBOX),
        "that is the mailbox of Pre-Operational"
    );
    assert_eq!(bench.request_with(BOOTSTRAP, &managers), Ok(()));
    // there is no CoE: mailbox error 2, the protocol is not supported, in the first message that is counted
    let message = [10, 0, 0, 0, 0, 0x13, 0, 0x20, 0x40, 0x00, 0x10, 0, 0, 0, 0, 0];
    let mut answer = [0; 256];
    let length = bench.drive.mail(&message, &mut answer);
    assert_eq!(answer[..length], [4, 0, 0, 0, 0, 0x10, 1, 0, 2, 0]);
    assert_eq!(bench.request(PRE_OP), Err(AlStatusCode::INVALID_CHANGE), "the way out is Init");
    assert_eq!(bench.request(INIT), Ok(()));
    assert_eq!(bench.request(PRE_OP), Ok(()));
}

/// S700, 3.5 and 3.6: one PDO each way. A second has no place, and a master that counts on it has the wrong length.
#[test]
fn a_second_pdo_has_no_place() {
    let device = device("s700");
    let mut bench = Bench::new(device, None);
    bench.request(PRE_OP).expect("nothing is wrong");
    let default = device.assigned(Role::Outputs).map(|pdo| pdo.index.0).next().expect("there is one");
    let at = |subindex| Address { index: Index(0x1C12), subindex };
    assert_eq!(bench.download(at(0), &[0]), Ok(()));
    assert_eq!(bench.download(at(1), &default.to_le_bytes()), Ok(()));
    // CiA 301: there is no such subindex, and more than fits is mapped
    assert_eq!(bench.download(at(2), &0x1706_u16.to_le_bytes()), Err(AbortCode(0x0609_0011)));
    assert_eq!(bench.download(at(0), &[2]), Err(AbortCode(0x0604_0042)));
    assert_eq!(bench.download(at(0), &[1]), Ok(()));
    let mut managers = bench.managers();
    managers[2].length += 12;
    assert_eq!(bench.request_with(SAFE_OP, &managers), Err(AlStatusCode::INVALID_OUTPUTS));
    assert_eq!(bench.request(SAFE_OP), Ok(()));
}
