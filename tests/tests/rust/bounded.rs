//! Bounds and texts of a generated dictionary, through the derive.

use devc_runtime::Device;
use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::Operational;
use devc_runtime::sdo::{AbortCode, Part, Server};

#[expect(unreachable_pub, reason = "a device is public, a test is not")]
#[derive(Device)]
#[device(path = "tests/rust/bounded")]
pub struct Bounded;

use bounded::dictionary::Dictionary;

fn server() -> Server<Dictionary> {
    Server::new(Dictionary::DEFAULT, ())
}

fn download(index: u16, subindex: u8, data: &[u8]) -> Result<(), AbortCode> {
    server().download(Address::new(index, subindex), Operational, data)
}

#[test]
fn bounds_are_those_of_the_description() {
    assert_eq!(download(0x2000, 1, &(-1_i16).to_le_bytes()), Ok(()));
    assert_eq!(download(0x2000, 1, &(-2_i16).to_le_bytes()), Err(AbortCode::VALUE_TOO_LOW));
    assert_eq!(download(0x2000, 1, &1001_i16.to_le_bytes()), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(download(0x2000, 2, &f32::MAX.to_le_bytes()), Ok(()));
    assert_eq!(download(0x2000, 2, &0.25_f32.to_le_bytes()), Err(AbortCode::VALUE_TOO_LOW));
    assert_eq!(download(0x2000, 3, &100_000_u32.to_le_bytes()[..3]), Ok(()));
    assert_eq!(download(0x2000, 3, &100_001_u32.to_le_bytes()[..3]), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(download(0x2000, 4, &(1_u64 << 63).to_le_bytes()), Err(AbortCode::VALUE_TOO_HIGH));
}

#[test]
fn an_axis_may_have_bounds_of_its_own() {
    for (index, limit) in [(0x607F, 5000_u32), (0x687F, 300), (0x6080, 6000), (0x6880, 6000)] {
        assert_eq!(download(index, 0, &limit.to_le_bytes()), Ok(()), "0x{index:04X}");
        let above = download(index, 0, &(limit + 1).to_le_bytes());
        assert_eq!(above, Err(AbortCode::VALUE_TOO_HIGH), "0x{index:04X}");
    }
    assert_eq!(download(0x687F, 0, &0_u32.to_le_bytes()), Err(AbortCode::VALUE_TOO_LOW));
    assert_eq!(download(0x6080, 0, &0_u32.to_le_bytes()), Ok(()));
}

#[test]
fn a_text_that_can_be_written_is_kept_in_the_struct() {
    let mut server = server();
    let place = Address::new(0x2001, 0);
    assert_eq!(server.values.place_of_installation, *b"line 4\0\0\0\0\0\0");
    assert_eq!(server.upload(place, Operational, &mut [0; 12]), Ok(b"line 4".as_slice()));
    assert_eq!(server.download(place, Operational, b"roof"), Ok(()));
    assert_eq!(server.upload(place, Operational, &mut [0; 12]), Ok(b"roof".as_slice()));
    assert_eq!(server.download(place, Operational, b"far too long!"), Err(AbortCode::LENGTH_TOO_HIGH));
}

#[test]
fn the_mailbox_says_whether_objects_are_transferred_whole() {
    let mut buffer = [0; 32];
    let mut part = Part::new(&mut buffer, 0);
    let gains = Address::new(0x2000, 0);
    assert_eq!(server().upload_complete(gains, Operational, &mut part), Ok(()));
    let whole = [&[4, 0][..], &[100, 0], &1.0_f32.to_le_bytes(), &[0x70, 0x11, 0x01], &[0; 8]].concat();
    assert_eq!(part.bytes(), whole);
    let mut buffer = [0; 32];
    let c887 = devc_generated::c887::dictionary::Dictionary::DEFAULT;
    let refused = Server::new(c887, ()).upload_complete(
        Address::new(0x1018, 0),
        Operational,
        &mut Part::new(&mut buffer, 0),
    );
    assert_eq!(refused, Err(AbortCode::UNSUPPORTED_ACCESS));
}
