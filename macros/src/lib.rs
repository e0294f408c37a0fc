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
/// The struct has to be public, as all the types are that name it. A change of the description rebuilds the crate,
/// and errors in it are errors of the code, with the place in the TOML.
///
/// | setting | meaning |
/// |---|---|
/// | `path = ".."` | the description |
/// | `module = ".."` | the name of the module, by default the struct's in snake case |
/// | `member = ".."` | the member of a family of devices that share a description |
/// | `runtime = ".."` | the path of `devc-runtime`, by default `::devc_runtime` |
#[proc_macro_derive(Device, attributes(device))]
pub fn device(input: TokenStream) -> TokenStream {
    let root = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    devc::derive::expand(input.into(), Path::new(&root), &Disk).into()
}
