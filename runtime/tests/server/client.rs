//! A master's transfers against a device, and against answers that are none.

use devc_runtime::coe::{Answered, Download, Emergency, Failure, Mailbox, Malformed, Upload};
use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::{Operational, PreOperational};
use devc_runtime::sdo::{AbortCode, Server};

use crate::device::{GAIN, LIST, MODEL, NAME, NOTE, SECRET, Tiny};
use crate::master::next_counter;

const SIZES: [usize; 6] = [16, 17, 20, 24, 31, 128];

type Device = Mailbox<Tiny, (), 16>;

fn device() -> Device {
    Mailbox::new(Server::new(Tiny::NEW, ()))
}

fn upload(device: &mut Device, size: usize, mut upload: Upload<'_>) -> Result<Vec<u8>, Failure> {
    for _ in 0..64 {
        let (mut message, mut answer) = (vec![0; size], vec![0; size]);
        let length = upload.request(next_counter(), &mut message)?;
        assert!(length <= size);
        let length = device.answer(&message, PreOperational, &mut answer);
        if upload.take(&answer[..length])? == Answered::Done {
            return Ok(upload.value().to_vec());
        }
    }
    panic!("it has no end");
}

fn download(device: &mut Device, size: usize, mut download: Download<'_>) -> Result<(), Failure> {
    for _ in 0..64 {
        let (mut message, mut answer) = (vec![0; size], vec![0; size]);
        let length = download.request(next_counter(), &mut message)?;
        assert!(length <= size);
        let length = device.answer(&message, PreOperational, &mut answer);
        if download.take(&answer[..length])? == Answered::Done {
            return Ok(());
        }
    }
    panic!("it has no end");
}

#[test]
fn values_of_any_length_are_read_and_written() {
    for size in SIZES {
        let mut device = device();
        for (address, value) in [(NAME, &b"tiny"[..]), (GAIN, &[5, 0]), (MODEL, b"model 1")] {
            let read = upload(&mut device, size, Upload::new(address, &mut [0; 16]));
            assert_eq!(read.as_deref(), Ok(value), "{address}, {size} bytes");
        }
        for text in ["", "a", "abcd", "abcde", "abcdefgh"] {
            let written = download(&mut device, size, Download::new(NOTE, text.as_bytes()));
            assert_eq!(written, Ok(()), "{text}, {size} bytes");
            let read = upload(&mut device, size, Upload::new(NOTE, &mut [0; 16]));
            assert_eq!(read.as_deref(), Ok(text.as_bytes()), "{size} bytes");
        }
        let read = upload(&mut device, size, Upload::new(MODEL, &mut [0; 7]));
        assert_eq!(read.as_deref(), Ok(&b"model 1"[..]), "a buffer that it just fills, {size} bytes");
        let whole = [3, 0, 7, 0, 8, 0, 9, 0];
        let from = Address::new(LIST, 0);
        assert_eq!(download(&mut device, size, Download::whole(from, &whole)), Ok(()));
        let read = upload(&mut device, size, Upload::whole(from, &mut [0; 16]));
        assert_eq!(read.as_deref(), Ok(&whole[..]), "{size} bytes");
    }
}

#[test]
fn what_the_device_refuses_fails() {
    let mut device = device();
    let refused = |code| Err(Failure::Aborted(code));
    assert_eq!(upload(&mut device, 16, Upload::new(SECRET, &mut [0; 8])), refused(AbortCode::WRITE_ONLY));
    assert_eq!(
        download(&mut device, 16, Download::new(NAME, b"new")).err(),
        Some(Failure::Aborted(AbortCode::READ_ONLY))
    );
    // the master's own buffer
    assert_eq!(upload(&mut device, 16, Upload::new(MODEL, &mut [0; 6])), Err(Failure::TooLong));
}

#[test]
fn other_messages_are_no_answers() {
    let mut buffer = [0; 8];
    let mut upload = Upload::new(GAIN, &mut buffer);
    let mut message = [0; 16];
    let mut device = device();
    let length = device.emergency(&Emergency { code: 0x7121, register: 1, data: [0; 5] }, &mut message);
    assert_eq!(upload.take(&message[..length]), Ok(Answered::Other));
    // of another entry, of a download, of no CoE
    let other = [10, 0, 0, 0, 0, 3, 0, 0x30, 0x4B, 2, 0x20, 0, 8, 0, 0, 0];
    assert_eq!(upload.take(&other), Err(Failure::Unexpected));
    let other = [10, 0, 0, 0, 0, 3, 0, 0x30, 0x60, 1, 0x20, 0, 0, 0, 0, 0];
    assert_eq!(upload.take(&other), Err(Failure::Unexpected));
    assert_eq!(upload.take(&[2, 0, 0, 0, 0, 3]), Err(Failure::Malformed(Malformed::WrongLength)));
    // a segment with the wrong toggle bit
    let mut long = Upload::new(MODEL, &mut message);
    let mut request = [0; 16];
    let mut answer = [0; 16];
    long.request(next_counter(), &mut request).unwrap();
    device.answer(&request, Operational, &mut answer);
    assert_eq!(long.take(&answer), Ok(Answered::More));
    let segment = [10, 0, 0, 0, 0, 3, 0, 0x30, 0x11, b'a', b'b', b'c', b'd', b'e', b'f', b'g'];
    assert_eq!(long.take(&segment), Err(Failure::Unexpected));
}

/// ETG.1000.6, SDO download responses: that of an entry names it, that of a segment has the toggle bit of the request.
#[test]
fn other_messages_are_no_answers_to_a_download() {
    let written = |index: u8, command: u8| [10, 0, 0, 0, 0, 3, 0, 0x30, command, index, 0x20, 0, 0, 0, 0, 0];
    let begun = || {
        let (mut download, mut request) = (Download::new(NOTE, b"abcdefgh"), [0; 16]);
        download.request(next_counter(), &mut request).unwrap();
        download
    };
    assert_eq!(begun().take(&written(4, 0x60)), Err(Failure::Unexpected), "it is 0x2003");
    assert_eq!(begun().take(&written(0, 0x20)), Err(Failure::Unexpected), "nothing was sent in a segment");
    let mut download = begun();
    assert_eq!(download.take(&written(3, 0x60)), Ok(Answered::More));
    download.request(next_counter(), &mut [0; 16]).unwrap();
    assert_eq!(download.take(&written(0, 0x30)), Err(Failure::Unexpected), "the toggle bit is 0 at first");
}
