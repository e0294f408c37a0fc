//! The EtherCAT states, with what a master may have set wrongly (ETG.1000.6, EtherCAT state machine).

use devc_runtime::esm::{AlStatusCode, Configured};
use devc_virtual::Firmware;

use crate::bench::{Bench, INIT, OP, PRE_OP, SAFE_OP, device, devices};

#[test]
fn every_configuration_leads_to_operational() {
    for device in devices() {
        for chosen in &device.configurations {
            let mut bench = Bench::new(device, Some(chosen));
            bench.start(Some(chosen));
            let (_, lengths) = bench.drive.expected();
            let carried = (bench.outputs.bytes(), bench.inputs.bytes());
            assert_eq!((lengths.outputs, lengths.inputs), carried, "{}, {}", device.name, chosen.name);
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
