//! Firmware and a control program in one, that has nothing to panic or to allocate with.
//!
//! Linked without a start file, and with a panic handler that calls what does not exist: if any of what `_start`
//! reaches could panic, the linker would look for it and fail. There is no allocator, and no crate that would ask
//! for one.
#![no_std]
#![no_main]

#[rustfmt::skip]
#[path = "../../../../generated/c887/c887.rs"]
mod c887;
#[rustfmt::skip]
#[path = "../../../../generated/pmc-sc6/pmc-sc6.rs"]
mod pmc_sc6;
#[rustfmt::skip]
#[path = "../../../../generated/s700/s700.rs"]
mod s700;

mod dictionary;
mod drive;
mod master;
mod process_data;

use core::hint::black_box;

unsafe extern "C" {
    fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    unsafe { a_panic_can_be_reached() }
}

/// The core library names it, though nothing unwinds.
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}

#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    loop {
        process_data::run();
        #[cfg(not(only_process_data))]
        {
            dictionary::run();
            drive::run();
            master::run();
        }
        #[cfg(with_a_panic)]
        black_box(black_box(&[0_u8][..])[black_box(1)]);
    }
}
