//! Every message in both directions: what is written is read again, and no bytes stop a reader.

use devc_runtime::coe::{
    Emergency, EntryDescription, Envelope, Information, ObjectDescription, Operation, Request, Response,
    Service,
};
use devc_runtime::object::Address;
use devc_runtime::sdo::{AbortCode, Access, DataType};

const ADDRESS: Address = Address::new(0x6060, 3);
const DATA: [u8; 12] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];

fn requests() -> Vec<Request<'static>> {
    let address = ADDRESS;
    let code = AbortCode::TIMEOUT;
    let mut requests = vec![Request::Abort { address, code }];
    for flag in [false, true] {
        requests.push(Request::Upload { address, is_complete: flag });
        requests.push(Request::UploadSegment { toggle: flag });
        requests.push(Request::Download { address, is_complete: flag, size: None, data: &DATA[..4] });
        for length in 0..=DATA.len() {
            let data = &DATA[..length];
            let size = Some(length.try_into().unwrap());
            requests.push(Request::Download { address, is_complete: flag, size, data });
            requests.push(Request::Download { address, is_complete: flag, size: Some(1000), data });
            requests.push(Request::DownloadSegment { toggle: flag, is_last: length < 7, data });
        }
    }
    requests
}

fn responses() -> Vec<Response<'static>> {
    let address = ADDRESS;
    let mut responses = vec![Response::Abort { address, code: AbortCode::READ_ONLY }];
    for flag in [false, true] {
        responses.push(Response::Downloaded { address, is_complete: flag });
        responses.push(Response::SegmentDownloaded { toggle: flag });
        for length in 0..=DATA.len() {
            let data = &DATA[..length];
            let size = Some(length.try_into().unwrap());
            responses.push(Response::Uploaded { address, is_complete: flag, size, data });
            responses.push(Response::SegmentUploaded { toggle: flag, is_last: length < 7, data });
        }
    }
    responses
}

#[test]
fn what_is_written_is_read_again() {
    let envelope = Envelope { address: 0x1001, channel: 5, priority: 2, counter: 4, ..ENVELOPE };
    for request in requests() {
        let mut frame = [0xAA; 64];
        let length = request.encode(envelope, &mut frame).unwrap();
        assert!(length >= 16, "{request:?} is shorter than a mailbox may be");
        let (found, body) = Envelope::open(&frame).unwrap();
        assert_eq!((found, body.len()), (envelope, length - 8));
        assert_eq!(Request::decode(body), Ok(request));
    }
    for response in responses() {
        let mut frame = [0xAA; 64];
        let length = response.encode(envelope, &mut frame).unwrap();
        let (found, body) = Envelope::open(&frame).unwrap();
        let service = match response {
            Response::Abort { .. } => Service::SDO_REQUEST,
            _ => Service::SDO_RESPONSE,
        };
        assert_eq!((found, body.len()), (Envelope { service, ..envelope }, length - 8));
        assert_eq!(Response::decode(body), Ok(response));
    }
}

const ENVELOPE: Envelope = Envelope::new(Service::SDO_REQUEST);

#[test]
fn descriptions_are_read_again_and_names_are_cut() {
    let object = ObjectDescription {
        index: 0x1018,
        data_type: DataType(0x23),
        highest_subindex: 4,
        code: 9,
        name: b"Identity",
    };
    let entry = EntryDescription {
        address: ADDRESS,
        value_info: 0,
        data_type: DataType::INTEGER8,
        bits: 8,
        access: Access(0x7F),
        values: &[],
        name: b"Modes of operation",
    };
    let mut frame = [0; 64];
    object.encode(ENVELOPE, &mut frame).unwrap();
    let information = Information::decode(Envelope::open(&frame).unwrap().1).unwrap();
    assert_eq!(information.operation, Operation::Object);
    assert_eq!(ObjectDescription::decode(information.data), Ok(object));
    let mut frame = [0; 27];
    assert_eq!(entry.encode(ENVELOPE, &mut frame), Ok(27));
    let information = Information::decode(Envelope::open(&frame).unwrap().1).unwrap();
    assert_eq!(information.operation, Operation::Entry);
    let cut = EntryDescription { name: b"Modes", ..entry };
    assert_eq!(EntryDescription::decode(information.data), Ok(cut));
}

/// Bytes of the values that an entry description tells, where it tells no unit.
fn told(body: &[u8]) -> usize {
    match body {
        [_, _, _, info, _, _, low, high, ..] if info & 0x08 == 0 => {
            let bits = usize::from(u16::from_le_bytes([*low, *high]));
            [0x10, 0x20, 0x40].iter().filter(|bit| info & **bit != 0).count() * bits.div_ceil(8)
        }
        _ => 0,
    }
}

#[test]
fn no_bytes_stop_a_reader() {
    let mut state = 1_u32;
    let mut random = || {
        // xorshift
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        state.to_le_bytes()[0]
    };
    for command in 0..=u8::MAX {
        for length in 0..24 {
            let mut body: Vec<u8> = (0..length).map(|_| random()).collect();
            if let Some(first) = body.first_mut() {
                *first = command;
            }
            let mut frame = [0; 64];
            if let Ok(request) = Request::decode(&body) {
                assert!(request.encode(ENVELOPE, &mut frame).is_ok(), "{request:?}");
            }
            if let Ok(response) = Response::decode(&body) {
                assert!(response.encode(ENVELOPE, &mut frame).is_ok(), "{response:?}");
            }
            let information = Information::decode(&body);
            assert_eq!(information.is_ok(), body.len() >= 4 && (1..=7).contains(&(command & 0x7F)));
            assert_eq!(Emergency::decode(&body).is_ok(), body.len() >= 8);
            let facts = [ObjectDescription::decode(&body).is_ok(), EntryDescription::decode(&body).is_ok()];
            assert_eq!(facts, [body.len() >= 6, body.len() >= 10 + told(&body)]);
        }
    }
}
