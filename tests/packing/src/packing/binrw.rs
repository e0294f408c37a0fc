//! The crate `binrw`: derived, to and from a cursor.

use std::io::Cursor;

use binrw::{BinRead, BinWrite};

use super::{INPUTS, OUTPUTS};

#[derive(Debug, Clone, Copy, BinRead, BinWrite)]
#[brw(little)]
pub struct Out {
    controlword: u16,
    mode: i8,
    position: i32,
}

#[derive(Debug, Clone, Copy, BinRead, BinWrite)]
#[brw(little)]
pub struct In {
    statusword: u16,
    mode: i8,
    position: i32,
    following_error: i32,
}

pub fn outputs() -> [Out; 6] {
    [Out { controlword: 6, mode: 8, position: -1 }; 6]
}

pub fn inputs() -> [In; 6] {
    [In { statusword: 0x0237, mode: 8, position: -1, following_error: 3 }; 6]
}

pub fn pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]) {
    axes.write_le(&mut Cursor::new(&mut frame[..])).unwrap();
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]) {
    *axes = BinRead::read_le(&mut Cursor::new(&frame[..])).unwrap();
}

pub fn pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]) {
    axes.write_le(&mut Cursor::new(&mut frame[..])).unwrap();
}

pub fn unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]) {
    *axes = BinRead::read_le(&mut Cursor::new(&frame[..])).unwrap();
}
