//! The identity of a device, and families of devices.

use crate::start_up::BringUp;

/// A device that a description tells of: the marker that its entries and PDOs carry, so that those of another
/// device do not fit where its own are asked for.
///
/// The numbers are those of the identity object 0x1018 (CiA 301), by which a master recognises the device.
///
/// ```
/// use devc_runtime::Device;
///
/// #[derive(Debug, Clone, Copy)]
/// struct C887;
///
/// impl Device for C887 {
///     const NAME: &'static str = "C-887.53x";
///     const VENDOR_ID: u32 = 0x0000_076D;
///     const PRODUCT_CODE: u32 = 3;
///     const REVISION: u32 = 0;
/// }
/// ```
pub trait Device {
    /// The name that people use for the device.
    const NAME: &'static str;
    /// 0x1018:01, given to the vendor by the ETG.
    const VENDOR_ID: u32;
    /// 0x1018:02, given to the product by the vendor.
    const PRODUCT_CODE: u32;
    /// 0x1018:03, the revision that the description holds for.
    const REVISION: u32;
}

/// Devices that have entries and process data in common: the members of a family, or one device alone.
///
/// It is what entries and PDOs belong to. A family has a type of its own for that, so that a program for all of its
/// members is written once; a device that is alone is its own family.
#[diagnostic::on_unimplemented(
    message = "nothing is known of the devices of `{Self}`",
    note = "the module of a device or of a family has a type that stands for it"
)]
pub trait Family {
    /// The devices, in the order in which [`Pdo::MEMBERS`](crate::pdo::Pdo::MEMBERS) counts them; never none.
    const MEMBERS: &'static [BringUp];
}
