//! Process data as `ethercrab` takes it.

use devc_runtime::pdo::ProcessData;
use ethercrab_wire::{
    EtherCrabWireRead, EtherCrabWireReadSized, EtherCrabWireSized, EtherCrabWireWrite,
    EtherCrabWireWriteSized, WireError,
};

use crate::c887::RxPdo1600;
use crate::numbers::Numbers;

/// What that master asks of data that it sends and receives.
fn through<P: EtherCrabWireReadSized + EtherCrabWireWrite + EtherCrabWireWriteSized>(
    data: &P,
) -> Result<P, WireError> {
    let mut buffer = P::buffer();
    assert_eq!(data.pack_to_slice(buffer.as_mut()), Ok(data.pack().as_ref()));
    assert_eq!((data.packed_len(), buffer.as_ref().len()), (P::PACKED_LEN, P::PACKED_LEN));
    P::unpack_from_slice(buffer.as_ref())
}

#[test]
fn bytes_are_those_of_the_process_data() {
    let mut numbers = Numbers::new();
    for _ in 0..100 {
        let image = numbers.bytes();
        let value = RxPdo1600::unpack(image);
        assert_eq!(through(&value), Ok(value));
        assert_eq!(EtherCrabWireWriteSized::pack(&value), image);
    }
    assert_eq!(RxPdo1600::PACKED_LEN, RxPdo1600::LEN);
}

#[test]
fn a_longer_buffer_is_used_from_its_beginning_and_a_shorter_one_refused() {
    let value = RxPdo1600::unpack([1, 2, 3, 4, 5, 6, 7]);
    let mut frame = [0xA5; 9];
    assert_eq!(value.pack_to_slice(&mut frame), Ok([1, 2, 3, 4, 5, 6, 7].as_slice()));
    assert_eq!(frame, [1, 2, 3, 4, 5, 6, 7, 0xA5, 0xA5]);
    assert_eq!(RxPdo1600::unpack_from_slice(&frame), Ok(value));
    assert_eq!(RxPdo1600::unpack_from_slice(&frame[..6]), Err(WireError::ReadBufferTooShort));
    assert_eq!(value.pack_to_slice(&mut frame[..6]), Err(WireError::WriteBufferTooShort));
}
