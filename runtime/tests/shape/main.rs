//! Generated code leans on the runtime as `c887.rs` does: by hand here, so that its shape is tried before devc makes it.

mod c887;
mod dictionary;
#[cfg(feature = "ethercrab")]
mod ethercrab;
mod numbers;
mod process_data;
mod views;
mod words;
