//! The derive of devc. Take it from `devc-runtime` with the feature `derive`.

use std::path::Path;

use devc::source::Disk;
use proc_macro::TokenStream;

/// Makes a module of a device's description: typed objects, process data, words, states, modes, errors and units.
///
/// ```ignore
/// use devc_runtime::Device;
///
/// #[derive(Device)]
/// #[device(path = "devices/c887")]
/// pub struct C887;
///
/// let target = c887::RxPdo1600 { .. };
/// ```
///
/// The path is that of a folder with a `device.toml`, or of a TOML file, from the folder of the crate's `Cargo.toml`.
/// The struct has to be public, as all the types are that name it, and has no generics. A change of the description rebuilds the crate,
/// and errors in it are errors of the code, with the place in the TOML.
///
/// | setting | meaning |
/// |---|---|
/// | `path = ".."` | the description |
/// | `module = ..` | the name of the module, by default the struct's in snake case |
/// | `member = ".."` | the member of a family of devices that share a description |
/// | `dictionary = false` | without the dictionary that a firmware keeps: a master does without |
/// | `runtime = ..` | the path of `devc-runtime`, by default `::devc_runtime` |
#[proc_macro_derive(Device, attributes(device))]
pub fn device(input: TokenStream) -> TokenStream {
    let root = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    devc::derive::expand(input.into(), Path::new(&root), &Disk).into()
}

/// Makes the process image of a struct whose fields are PDOs of a device, or arrays of the PDOs of its axes: all that
/// the device receives in a cycle, or all that it sends.
///
/// ```ignore
/// use c887::{Axis, RxPdo1600, RxPdo1601};
/// use devc_runtime::pdo::ProcessImage;
///
/// #[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
/// pub struct Outputs {
///     pub cyclic: [RxPdo1600; 3],
///     #[image(axis = Axis::U)]
///     pub profile: [RxPdo1601; 3],
/// }
/// ```
///
/// It gets `ProcessData`, `ProcessImage` with the PDOs to assign, and a view `OutputsView` that has those of the PDOs.
/// An array begins with the first axis, if `axis` names no other. What the device forbids does not compile: PDOs of
/// another device or direction, the same twice, two that exclude each other, too many, one missing, too many bytes.
///
/// | setting | meaning |
/// |---|---|
/// | `axis = ..` | on a field: the axis that the PDO, or the first of the array, is for |
/// | `runtime = ..` | on the struct: the path of `devc-runtime`, by default `::devc_runtime` |
#[proc_macro_derive(ProcessImage, attributes(image))]
pub fn process_image(input: TokenStream) -> TokenStream {
    devc::derive::process_image(input.into()).into()
}

/// Makes a PDO of a struct whose fields are the entries that the user maps to it, for devices with a free mapping.
///
/// ```ignore
/// use devc_runtime::pdo::Pdo;
/// use s700::{Controlword, objects};
///
/// #[derive(Debug, Clone, Copy, PartialEq, Pdo)]
/// #[pdo(mapping = s700::FreeRxPdo1600)]
/// pub struct Setpoints {
///     pub controlword: Controlword,
///     #[pdo(objects::POSITION_SETPOINT)]
///     pub position: i32,
/// }
/// ```
///
/// It gets `ProcessData`, `Pdo` with the mapping that the start-up list writes, and a view `SetpointsView`. A field
/// without an entry has that of its name, in `objects` beside the free PDO. What does not compile: an entry that is
/// not there, another device's, one of another type, one that cannot be mapped this way, a PDO whose mapping is fixed,
/// more than the PDO takes.
///
/// `#[pdo(objects::POSITION_SETPOINT, gap = 8)]` leaves 8 bits free in front of a field (ETG.1000.6, PDO mapping):
/// they are sent as zeros and not read. Descriptions do not tell whether a device takes gaps; one that does not
/// refuses the start-up list.
///
/// | setting | meaning |
/// |---|---|
/// | `mapping = ..` | the free PDO, a type of the device's module |
/// | `per_axis` | each axis has the PDO: entries are functions of the axis, called for each |
/// | `gap = ..` | on a field: bits in front of it; on the struct: bits behind the last field; from 1 to 255 |
/// | `runtime = ..` | the path of `devc-runtime`, by default `::devc_runtime` |
#[proc_macro_derive(Pdo, attributes(pdo))]
pub fn pdo(input: TokenStream) -> TokenStream {
    devc::derive::own_pdo(input.into()).into()
}
