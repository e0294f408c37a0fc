//! The images of the C-887: six axes, 42 bytes out and 66 bytes in.

mod binrw;
mod by_hand;
mod c;
mod deku;
mod ethercrab;
mod generated;
mod in_place;
mod unwrapped;
mod zero_copy;

use std::hint::black_box;

use crate::Task;

pub const OUTPUTS: usize = 42;
pub const INPUTS: usize = 66;

/// What goes to an axis.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C)]
pub struct Out {
    pub controlword: u16,
    pub mode: i8,
    pub position: i32,
}

/// What comes from an axis.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C)]
pub struct In {
    pub statusword: u16,
    pub mode: i8,
    pub position: i32,
    pub following_error: i32,
}

/// A way to pack and to unpack an image of `N` bytes.
struct Way<V, const N: usize> {
    value: V,
    pack: fn(&V, &mut [u8; N]),
    unpack: fn(&[u8; N], &mut V),
}

impl<V, const N: usize> Way<V, N> {
    fn run(mut self, task: &Task, name: &str, image: &str) {
        let mut frame = [0x5A; N];
        let (pack, unpack) = black_box((self.pack, self.unpack));
        task.subject(&format!("{name}, pack {image}"), || {
            pack(black_box(&self.value), black_box(&mut frame))
        });
        task.subject(&format!("{name}, unpack {image}"), || {
            unpack(black_box(&frame), black_box(&mut self.value))
        });
    }
}

/// Both images in one way.
macro_rules! both {
    ($task:ident, $name:literal, $($module:ident)::+) => {
        Way { value: $($module::)+outputs(), pack: $($module::)+pack_outputs, unpack: $($module::)+unpack_outputs }
            .run($task, $name, "outputs");
        Way { value: $($module::)+inputs(), pack: $($module::)+pack_inputs, unpack: $($module::)+unpack_inputs }
            .run($task, $name, "inputs");
    };
}

pub fn run(task: &Task) {
    let empty = Way::<(), OUTPUTS> { value: (), pack: |_, _| {}, unpack: |_, _| {} };
    empty.run(task, "nothing", "outputs");
    let empty = Way::<(), INPUTS> { value: (), pack: |_, _| {}, unpack: |_, _| {} };
    empty.run(task, "nothing", "inputs");
    both!(task, "C, field by field", c);
    both!(task, "C, packed struct", c::packed);
    both!(task, "devc, by value", generated);
    both!(task, "devc, in place", in_place);
    both!(task, "zerocopy", zero_copy);
    both!(task, "by hand, arrays", by_hand);
    both!(task, "by hand, slices", unwrapped);
    both!(task, "ethercrab-wire", ethercrab);
    both!(task, "binrw", binrw);
    both!(task, "deku", deku);
}
