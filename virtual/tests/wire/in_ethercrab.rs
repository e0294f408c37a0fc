//! ethercrab as the master, in process: its frames go through the wire, and time goes on with each.

use std::future::Future;
use std::time::Duration;

use devc_virtual::{Subdevice, Wire};
use ethercrab::error::Error;
use ethercrab::subdevice_group::{DcConfiguration, Op, PreOp};
use ethercrab::{DcSync, DefaultLock, MainDevice, MainDeviceConfig, PduStorage, SubDeviceGroup};
use futures_lite::future;

use crate::carried::{carry, patient};
use crate::devices::{Any, Device, all, c887, described, s700};

type Group<State> = SubDeviceGroup<16, 1024, DefaultLock, State>;

/// Runs what a master does at a wire.
fn run<R, F: Future<Output = R>>(
    subdevices: Vec<Subdevice<Any>>,
    master: impl FnOnce(&'static MainDevice<'static>) -> F,
) -> R {
    let storage: &'static PduStorage<16, 1536> = Box::leak(Box::new(PduStorage::new()));
    let (to_wire, from_wire, pdu_loop) = storage.try_split().expect("once");
    let config = MainDeviceConfig { dc_static_sync_iterations: 100, ..MainDeviceConfig::default() };
    let maindevice = Box::leak(Box::new(MainDevice::new(pdu_loop, patient(Duration::from_secs(20)), config)));
    let mut wire: Wire<Any> = Wire::new(subdevices);
    let carried = carry(to_wire, from_wire, &mut wire, |wire, _| wire.advance(Duration::from_micros(100)));
    future::block_on(future::or(async { master(maindevice).await }, carried))
}

async fn found(maindevice: &MainDevice<'_>) -> Result<Group<PreOp>, Error> {
    maindevice.init_single_group::<16, 1024>(|| 0).await
}

/// The nine devices, made in two ways: of generated code, and of their descriptions.
fn both() -> [Vec<Subdevice<Any>>; 2] {
    [all().into_iter().map(Device::subdevice).collect(), described()]
}

#[test]
fn all_nine_are_found_by_their_identity() {
    let expected: Vec<_> = all().iter().map(|device| device.identity).collect();
    for subdevices in both() {
        let seen = run(subdevices, async |maindevice| {
            let group = found(maindevice).await.expect("they are found");
            let identity = group.iter(maindevice).map(|subdevice| subdevice.identity());
            identity.map(|it| [it.vendor_id, it.product_id, it.revision]).collect::<Vec<_>>()
        });
        assert_eq!(seen, expected);
    }
}

/// Init to Operational, all nine on one wire, with the lengths that the descriptions say; then cycles of process data.
#[test]
fn all_nine_come_to_operational() {
    let expected: Vec<_> = all().iter().map(|device| device.lengths).collect();
    for subdevices in both() {
        run(subdevices, async |maindevice| {
            let group = found(maindevice).await.expect("they are found");
            let group = group.into_safe_op(maindevice).await.expect("Safe-Operational");
            for (subdevice, (outputs, inputs)) in group.iter(maindevice).zip(&expected) {
                let (io, name) = (subdevice.io_raw(), subdevice.name());
                assert_eq!((io.outputs().len(), io.inputs().len()), (*outputs, *inputs), "{name}");
            }
            group.tx_rx(maindevice).await.expect("outputs come before Operational");
            let group: Group<Op> = group.into_op(maindevice).await.expect("Operational");
            for _ in 0..100 {
                // each reads and writes: 1 + 2
                let response = group.tx_rx(maindevice).await.expect("a cycle");
                assert_eq!(response.working_counter, 9 * 3);
            }
        });
    }
}

/// The clocks are set and kept by the master, and every device has its SYNC0; the master's cycle follows them.
#[test]
fn all_nine_run_with_distributed_clocks() {
    const PERIOD: Duration = Duration::from_millis(1);
    run(described(), async |maindevice| {
        let mut group = found(maindevice).await.expect("they are found");
        for mut subdevice in group.iter_mut(maindevice) {
            assert!(subdevice.dc_support().any());
            subdevice.set_dc_sync(DcSync::Sync0);
        }
        let delays: Vec<u32> = group.iter(maindevice).map(|it| it.propagation_delay()).collect();
        assert!(delays.is_sorted_by(|first, second| first < second), "{delays:?}");
        let group = group.into_pre_op_pdi(maindevice).await.expect("process data");
        let start_delay = Duration::from_millis(5);
        let clocks = DcConfiguration { start_delay, sync0_period: PERIOD, sync0_shift: Duration::ZERO };
        let group = group.configure_dc_sync(maindevice, clocks).await.expect("SYNC0");
        let group = group.into_safe_op(maindevice).await.expect("Safe-Operational");
        group.tx_rx_dc(maindevice).await.expect("outputs come before Operational");
        let group = group.into_op(maindevice).await.expect("Operational");
        let mut last = 0;
        for _ in 0..100 {
            let response = group.tx_rx_dc(maindevice).await.expect("a cycle");
            assert_eq!(response.working_counter, 9 * 3);
            assert!(response.extra.next_cycle_wait <= PERIOD);
            assert!(response.extra.dc_system_time > last);
            last = response.extra.dc_system_time;
        }
        for subdevice in group.iter(maindevice) {
            // the difference to the first, in its amount
            let difference: u32 = subdevice.register_read(0x092C_u16).await.expect("a register");
            assert!(difference & 0x7FFF_FFFF < 1_000, "{difference:#010X}");
        }
    });
}

#[test]
fn the_dictionary_is_read_and_written() {
    run(vec![c887().subdevice()], async |maindevice| {
        let group = found(maindevice).await.expect("it is found");
        let hexapod = group.subdevice(maindevice, 0).expect("the first");
        assert_eq!(hexapod.sdo_read::<u32>(0x1018, 1).await, Ok(0x0000_076D));
        hexapod.sdo_write(0x1C12, 0, 0_u8).await.expect("the assignment is cleared");
        hexapod.sdo_write(0x1C12, 1, 0x1601_u16).await.expect("another PDO");
        let refused = hexapod.sdo_write(0x6064, 0, 0_u32).await;
        assert!(matches!(refused, Err(Error::Mailbox(_))), "{refused:?}");
    });
}

/// What is mapped otherwise makes the process data as long.
#[test]
fn another_assignment_has_another_length() {
    run(vec![s700().subdevice()], async |maindevice| {
        let group = found(maindevice).await.expect("it is found");
        for (object, pdo) in [(0x1C12, 0x1706_u16), (0x1C13, 0x1B06)] {
            let drive = group.subdevice(maindevice, 0).expect("the first");
            drive.sdo_write(object, 0, 0_u8).await.expect("cleared");
            drive.sdo_write(object, 1, pdo).await.expect("assigned");
            drive.sdo_write(object, 0, 1_u8).await.expect("counted");
        }
        let group = group.into_safe_op(maindevice).await.expect("Safe-Operational");
        let io = group.subdevice(maindevice, 0).expect("the first");
        let io = io.io_raw();
        // manual 3.5 and 3.6: "total (12 Byte)"
        assert_eq!((io.outputs().len(), io.inputs().len()), (12, 12));
    });
}
