//! Process data (CiA 301, PDO; ETG.1000.6, PDO).
//!
//! Each PDO is generated as a struct with a field for each mapped entry, and as a view of its bytes in the frame.
//!
//! | for | there is |
//! |---|---|
//! | all values at once | [`ProcessData`]: `pack` is one array literal of all bytes, `unpack` one array pattern |
//! | single values, in place | [`InPlace`]: a view that loads and stores a field where it lies in the frame |
//!
//! Neither has an offset that is computed at run time, and so no check that could fail, at any optimisation level.

mod data;
mod direction;
#[cfg(feature = "ethercrab")]
#[doc(hidden)]
pub mod ethercrab;
mod image;
mod in_place;
mod mapping;
#[cfg(not(feature = "ethercrab"))]
mod no_ethercrab;
mod own;
pub mod place;
mod sync_manager;

pub use data::ProcessData;
#[cfg(feature = "derive")]
pub use devc_macros::{Pdo, ProcessImage};
pub use devc_start_up::{Carrier, Mapping, Members};
pub use direction::{Direction, Rx, Tx};
pub(crate) use image::refuse;
pub use image::{ProcessImage, SameDevice, SameDirection, check_image, check_pdo, of_axis, selected};
pub use in_place::{InPlace, View, ViewMut};
pub use mapping::{MappedPdo, Pdo};
pub use own::{MappingObject, MapsTo, RxTx, Unmapped, check_entry, check_mapping, mapped, own};
pub use sync_manager::SyncManager;
