//! The C-887 through the derive, as a user has it.

use devc_runtime::Device;

#[expect(unreachable_pub, reason = "a device is public, a test is not")]
#[derive(Device, Debug, Clone, Copy, PartialEq, Eq)]
#[device(path = "../devices/c887")]
pub struct C887;

#[test]
fn the_derive_gives_the_identity_and_the_module() {
    assert_eq!((C887::NAME, C887::VENDOR_ID, C887::PRODUCT_CODE), ("C-887.53x", 0x076D, 3));
    let target = c887::objects::target_position(c887::Axis::W);
    assert_eq!(target.to_string(), "0x887A:00");
    assert_eq!(target.encode(-1), [0xFF; 4]);
}
