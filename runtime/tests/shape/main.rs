//! Generated code leans on the runtime: the module of the C-887 as devc made it, against the manual and against bytes laid
//! out by hand.

#[rustfmt::skip]
#[path = "../../../generated/c887/c887.rs"]
mod c887;
mod dictionary;
#[cfg(feature = "ethercrab")]
mod ethercrab;
mod numbers;
mod process_data;
mod texts;
mod values;
mod views;
mod words;
