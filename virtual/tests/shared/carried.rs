//! What carries the frames of ethercrab through a wire in the same process.

use std::time::Duration;

use devc_virtual::{Firmware, Wire};
use ethercrab::{PduRx, PduTx, Timeouts};
use futures_lite::future;

/// Times so long that only what never comes is late, whatever else the machine does.
pub(crate) fn patient(long: Duration) -> Timeouts {
    Timeouts {
        state_transition: long,
        pdu: long,
        eeprom: long,
        wait_loop_delay: Duration::ZERO,
        mailbox_echo: long,
        mailbox_response: long,
    }
}

/// Takes each frame through the wire and back; `passed` is what happens after each, which it sees as it went and as it came. It goes on for as long as it is asked.
pub(crate) async fn carry<F: Firmware, R>(
    mut to_wire: PduTx<'_>,
    mut from_wire: PduRx<'_>,
    wire: &mut Wire<F>,
    mut passed: impl FnMut(&mut Wire<F>, [&[u8]; 2]),
) -> R {
    loop {
        while let Some(sendable) = to_wire.next_sendable_frame() {
            let mut frame = Vec::new();
            let sent = sendable.send_blocking(|bytes| {
                frame.extend_from_slice(bytes);
                Ok(bytes.len())
            });
            assert_eq!(sent, Ok(frame.len()));
            let gone = frame.clone();
            assert!(wire.pass(&mut frame));
            from_wire.receive_frame(&frame).expect("it is taken");
            passed(wire, [&gone, &frame]);
        }
        future::yield_now().await;
    }
}
