//! Images packed and unpacked, each in each way: checked first, then measured.

mod binrw;
mod by_hand;
mod by_value;
mod c;
mod c_generated;
mod c_packed;
mod deku;
mod ethercrab;
mod images;
mod in_place;
mod nothing;
mod unwrapped;
mod zero_copy;

use std::hint::black_box;

use crate::Task;

/// Packs a value into a frame. By the calling convention of C, so that calling C costs nothing more.
pub type Pack<V, const N: usize> = extern "C-unwind" fn(&V, &mut [u8; N]);

/// Unpacks a frame into a value.
pub type Unpack<V, const N: usize> = extern "C-unwind" fn(&[u8; N], &mut V);

/// The values of an image.
pub trait Values: Sized {
    const ZERO: Self;

    /// All fields, one PDO after the other.
    fn fields(&self) -> Vec<i64>;
}

/// One way to convert the values of an image of `N` bytes.
pub trait Image<const N: usize>: Values {
    const PACK: Pack<Self, N>;
    const UNPACK: Unpack<Self, N>;
}

/// All images in each way.
macro_rules! ways {
    ($task:ident: $($name:literal $way:ident)*) => {
        $(
            run_image::<$way::C887Outputs, 42>($task, $name, "C-887 outputs");
            run_image::<$way::C887Inputs, 66>($task, $name, "C-887 inputs");
            run_image::<$way::S700Inputs, 40>($task, $name, "S700 inputs");
            run_image::<$way::PilzInputs, 58>($task, $name, "Pilz inputs");
        )*
    };
}

pub fn run(task: &Task) {
    ways! { task:
        "nothing" nothing
        "C, field by field" c
        "C, packed struct" c_packed
        "devc, C" c_generated
        "devc, in place" in_place
        "devc, by value" by_value
        "zerocopy" zero_copy
        "by hand, arrays" by_hand
        "by hand, slices" unwrapped
        "ethercrab-wire" ethercrab
        "binrw" binrw
        "deku" deku
    }
}

fn run_image<V: Image<N>, const N: usize>(task: &Task, way: &str, image: &str) {
    let (mut value, mut frame) = (V::ZERO, images::frame::<N>());
    V::UNPACK(&frame, &mut value);
    check(way, &value);
    let (pack, unpack) = black_box((V::PACK, V::UNPACK));
    let name = format!("{way}, pack {image}");
    task.function(&name, pack as usize);
    task.subject(&name, || pack(black_box(&value), black_box(&mut frame)));
    let name = format!("{way}, unpack {image}");
    task.function(&name, unpack as usize);
    task.subject(&name, || unpack(black_box(&frame), black_box(&mut value)));
}

/// Whether the way has each field where the manual has it, and packs what it has unpacked.
fn check<V: Image<N>, const N: usize>(way: &str, value: &V) {
    let fields = value.fields();
    if fields.is_empty() {
        return;
    }
    assert!(fields.ends_with(images::last_fields(N)), "{way}, {N} bytes: {fields:x?}");
    let mut packed = [0xFF; N];
    V::PACK(value, &mut packed);
    assert_eq!(packed, images::frame(), "{way}");
}
