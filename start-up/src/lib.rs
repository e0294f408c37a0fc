//! The start-up list of an EtherCAT device: which writes through the mailbox bring a choice of process data about, and
//! in which order.
//!
//! It lies below both who describes devices and who runs them: `devc` puts the list into what it makes of a description,
//! and `devc-runtime` makes it of the types of a program while that is compiled. So all of it is `const`, and nothing
//! allocates.
//!
//! ```
//! use devc_start_up::{Address, Carrier, Choice, MappedPdo, Mapping, Step, Way};
//!
//! let mapping = [Mapping { address: Address::new(0x6040, 0), bits: 16 }];
//! let carriers = [Carrier { assignment: 0x1C12, pdos: &[0x1600] }];
//! let outputs = [MappedPdo::own(0x1600, &mapping)];
//! let outputs = Way { carriers: &carriers, mapped: &outputs, assigned: Some(&outputs) };
//! let choice = Choice { outputs, ..Choice::NONE };
//!
//! let mut steps = [Step::NONE; 6];
//! assert_eq!(choice.steps(&mut steps), 6);
//! let written = steps.map(|step| (step.address.index, step.address.subindex, step.data().to_vec()));
//! assert_eq!(written, [
//!     (0x1C12, 0, vec![0]), // nothing is assigned while mappings change
//!     (0x1600, 0, vec![0]),
//!     (0x1600, 1, vec![0x10, 0x00, 0x40, 0x60]),
//!     (0x1600, 0, vec![1]), // a count comes after what it counts
//!     (0x1C12, 1, vec![0x00, 0x16]),
//!     (0x1C12, 0, vec![1]),
//! ]);
//! ```
#![no_std]

mod address;
mod choice;
mod cycle;
mod list;
mod mapping;
mod members;
mod step;

pub use address::Address;
pub use choice::{AxisObjects, Carrier, Choice, Way};
pub use cycle::{CycleLimit, Interface, Period};
pub use mapping::{MappedPdo, Mapping};
pub use members::Members;
pub use step::{Step, Task};
