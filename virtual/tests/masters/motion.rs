//! Axes that a foreign master moves.

use std::cell::Cell;

use devc::model::{Address, Index};
use ethercrab::error::{Error, MailboxError};

use crate::bus::{found, run};
use crate::session::Session;
use crate::shared::{all, device, devices};

/// The set-point and the position of cyclic synchronous position mode (S700, 3.7.1 and 3.7.2; CiA 402).
fn positions(session: &Session<'_>) -> (u16, u16) {
    let is_kollmorgen = session.device.identity.vendor_id == 0x6A;
    if is_kollmorgen { (0x60C1, 0x6063) } else { (0x607A, 0x6064) }
}

#[test]
fn all_axes_follow_in_every_configuration_that_sends_positions() {
    let mut moved = 0;
    for device in all() {
        for chosen in &device.configurations {
            moved += run(
                device,
                |_| (),
                async |master| {
                    let mut session = Session::begin(master, device, Some(chosen)).await;
                    let (target, actual) = positions(&session);
                    if !session.sends(0, target) {
                        return 0;
                    }
                    session.enable().await;
                    session.select(8).await;
                    for step in 1..=200 {
                        for axis in session.axes() {
                            session.set(axis, target, step * (7 - 5 * axis as i64)).await;
                        }
                        session.cycles(1).await;
                    }
                    session.cycles(30).await;
                    for axis in session.axes() {
                        let end = 200 * (7 - 5 * axis as i64);
                        assert_eq!(session.get(axis, actual).await, end, "{}, axis {axis}", device.name);
                    }
                    session.command(0x06).await;
                    session.all_show("ready-to-switch-on").await;
                    session.axes().len()
                },
            );
        }
    }
    // six of the C-887, one of each S in position and two in free mapping, three times one and two of each Pilz, and one
    assert_eq!(moved, 6 + 4 + 2 + 3 * (2 + 1 + 2 + 1) + 1);
}

#[test]
fn a_fault_is_seen_and_reset() {
    let fault = Cell::new(None);
    for device in devices() {
        let provoke = |drive: &mut devc_virtual::drive::Drive| {
            if let Some((axis, code)) = fault.take() {
                drive.fault(axis, code);
            }
        };
        run(device, provoke, async |master| {
            let mut session = Session::begin(master, device, None).await;
            session.enable().await;
            fault.set(Some((0, 0x7121)));
            session.cycles(20).await;
            session.shows(0, "fault").await;
            // the code in 0x603F and the register in 0x1001, for those that have them: generic and manufacturer-specific
            if device.object(Index(0x603F)).is_some() {
                assert_eq!(session.get(0, 0x603F).await, 0x7121, "{}", device.name);
            }
            if device.entry(REGISTER).is_some() {
                assert_eq!(session.upload(REGISTER).await, Ok(vec![0x81]), "{}", device.name);
            }
            for word in [0x00, 0x80, 0x00] {
                session.command(word).await;
            }
            session.all_show("switch-on-disabled").await;
            if device.entry(REGISTER).is_some() {
                assert_eq!(session.upload(REGISTER).await, Ok(vec![0x00]), "{}", device.name);
            }
            session.enable().await;
        });
    }
}

const REGISTER: Address = Address { index: Index(0x1001), subindex: 0 };

/// What a device does not let a master map, and what it lets it: S700, 3.6 and 3.6.1.
#[test]
fn a_mapping_that_is_forbidden_is_refused() {
    run(
        device("s700"),
        |_| (),
        async |master| {
            let group = found(master).await;
            let drive = group.subdevice(master, 0).expect("the first");
            drive.sdo_write(0x1600, 0, 0_u8).await.expect("cleared");
            drive.sdo_write(0x1600, 1, 0x6040_0010_u32).await.expect("the controlword is mappable");
            let refused = drive.sdo_write(0x1600, 2, 0x6041_0010_u32).await;
            assert!(matches!(refused, Err(Error::Mailbox(MailboxError::Aborted { .. }))), "{refused:?}");
        },
    );
}
