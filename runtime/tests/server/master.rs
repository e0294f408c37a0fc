//! A master's side in a few lines: transfers of any length through a mailbox of any size.

use std::cell::Cell;

use devc_runtime::coe::{Envelope, Mailbox, Malformed, Request, Response, Service};
use devc_runtime::object::Address;
use devc_runtime::sdo::{AbortCode, CommunicationState, Hooks, Values};

/// A mailbox of so many bytes each way.
pub(crate) struct Master {
    pub(crate) size: usize,
    pub(crate) state: CommunicationState,
    pub(crate) is_complete: bool,
}

/// Sends a request and reads the answer.
fn exchange<V: Values, H: Hooks<V>, const N: usize, T>(
    master: &Master,
    mailbox: &mut Mailbox<V, H, N>,
    request: Request<'_>,
    read: impl FnOnce(Response<'_>) -> T,
) -> Result<T, AbortCode> {
    let (mut message, mut answer) = (vec![0; master.size], vec![0xAA; master.size]);
    request.encode(Envelope { counter: next_counter(), ..ENVELOPE }, &mut message).expect("it fits");
    let length = mailbox.answer(&message, master.state, &mut answer);
    assert!(length <= master.size, "{length} bytes");
    let (envelope, body) = Envelope::open(&answer[..length]).expect("it is an answer");
    assert!((1..=7).contains(&envelope.counter));
    match Response::decode(body).expect("it is an answer") {
        Response::Abort { code, .. } => Err(code),
        response => Ok(read(response)),
    }
}

/// The counter of the next message of this thread, which has one master.
pub(crate) fn next_counter() -> u8 {
    thread_local! {
        static LAST: Cell<u8> = const { Cell::new(0) };
    }
    LAST.set(LAST.get() % 7 + 1);
    LAST.get()
}

const ENVELOPE: Envelope = Envelope::new(Service::SDO_REQUEST);

impl Master {
    pub(crate) fn upload<V: Values, H: Hooks<V>, const N: usize>(
        &self,
        mailbox: &mut Mailbox<V, H, N>,
        address: Address,
    ) -> Result<Vec<u8>, AbortCode> {
        let request = Request::Upload { address, is_complete: self.is_complete };
        let (size, mut value) = exchange(self, mailbox, request, |response| match response {
            Response::Uploaded { address: of, is_complete, size: Some(size), data } => {
                assert_eq!((of, is_complete), (address, self.is_complete));
                (usize::try_from(size).unwrap(), data.to_vec())
            }
            other => panic!("{other:?}"),
        })?;
        let mut toggle = false;
        while value.len() < size {
            let request = Request::UploadSegment { toggle };
            let is_last = exchange(self, mailbox, request, |response| match response {
                Response::SegmentUploaded { toggle: same, is_last, data } => {
                    assert_eq!(same, toggle);
                    assert!(!data.is_empty());
                    value.extend_from_slice(data);
                    is_last
                }
                other => panic!("{other:?}"),
            })?;
            assert_eq!(is_last, value.len() == size);
            toggle = !toggle;
        }
        Ok(value)
    }

    pub(crate) fn download<V: Values, H: Hooks<V>, const N: usize>(
        &self,
        mailbox: &mut Mailbox<V, H, N>,
        address: Address,
        value: &[u8],
    ) -> Result<(), AbortCode> {
        let is_complete = self.is_complete;
        let fits = if (1..=4).contains(&value.len()) { 4 } else { self.size - 16 };
        let (first, mut rest) = value.split_at(fits.min(value.len()));
        let size = Some(value.len().try_into().unwrap());
        let request = Request::Download { address, is_complete, size, data: first };
        exchange(self, mailbox, request, |response| {
            assert_eq!(response, Response::Downloaded { address, is_complete });
        })?;
        let mut toggle = false;
        while !rest.is_empty() {
            let (data, more) = rest.split_at(rest.len().min(self.size - 9));
            let request = Request::DownloadSegment { toggle, is_last: more.is_empty(), data };
            exchange(self, mailbox, request, |response| {
                assert_eq!(response, Response::SegmentDownloaded { toggle });
            })?;
            (rest, toggle) = (more, !toggle);
        }
        Ok(())
    }
}

/// The answer to a message as it is, and its length.
pub(crate) fn raw<V: Values, H: Hooks<V>, const N: usize>(
    mailbox: &mut Mailbox<V, H, N>,
    request: Request<'_>,
) -> Result<Vec<u8>, Malformed> {
    let mut message = [0; 64];
    let length = request.encode(ENVELOPE, &mut message)?;
    let mut answer = vec![0; 32];
    let length = mailbox.answer(&message[..length], CommunicationState::PreOperational, &mut answer);
    answer.truncate(length);
    Ok(answer)
}
