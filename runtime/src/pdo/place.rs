//! Fields and parts of an image, at places that are known when the code is compiled.
//!
//! This is what views are made of. All functions are generic over the place, so that one that does not lie in the
//! image does not compile, and the loads and stores that are left know their addresses.

use crate::bytes::ByteArray;
use crate::object::Value;

/// Loads the value whose first bit is bit `OFFSET` of the image. A value of fewer bits than its type has is extended,
/// with its sign if it has one; of more, the highest are left out.
///
/// ```
/// use devc_runtime::pdo::place::load;
///
/// let image = [0b0101_0110, 0x34, 0x12];
/// assert_eq!(load::<u16, 8, 16, 3>(&image), 0x1234);
/// assert_eq!(load::<bool, 1, 1, 3>(&image), true);
/// assert_eq!(load::<i8, 4, 4, 3>(&image), 5);
/// assert_eq!(load::<i8, 1, 2, 3>(&image), -1);
/// ```
///
/// ```compile_fail,E0080
/// let beyond = devc_runtime::pdo::place::load::<u16, 16, 16, 3>(&[0; 3]);
/// ```
#[inline]
pub fn load<T: Value, const OFFSET: usize, const BITS: usize, const LENGTH: usize>(
    image: &[u8; LENGTH],
) -> T {
    const { assert!(OFFSET + BITS <= 8 * LENGTH, "the field does not lie in the image") };
    let bytes = image.get(const { OFFSET / 8 }..).unwrap_or_default();
    if const { OFFSET.is_multiple_of(8) && BITS == 8 * T::SIZE } {
        let whole = bytes.get(..T::SIZE).and_then(|bytes| T::Bytes::from_slice(bytes).ok());
        return T::from_bytes(whole.copied().unwrap_or(T::Bytes::ZERO));
    }
    load_bits::<T, OFFSET, BITS>(bytes)
}

/// Stores a value where [`load`] finds it; the bits around it stay.
///
/// ```
/// use devc_runtime::pdo::place::store;
///
/// let mut image = [0xFF; 3];
/// store::<u16, 8, 16, 3>(&mut image, 0x1234);
/// store::<u8, 2, 4, 3>(&mut image, 0b1001);
/// assert_eq!(image, [0b1110_0111, 0x34, 0x12]);
/// ```
#[inline]
pub fn store<T: Value, const OFFSET: usize, const BITS: usize, const LENGTH: usize>(
    image: &mut [u8; LENGTH],
    value: T,
) {
    const { assert!(OFFSET + BITS <= 8 * LENGTH, "the field does not lie in the image") };
    let bytes = image.get_mut(const { OFFSET / 8 }..).unwrap_or_default();
    if const { OFFSET.is_multiple_of(8) && BITS == 8 * T::SIZE } {
        if let Some(Ok(place)) = bytes.get_mut(..T::SIZE).map(T::Bytes::from_slice_mut) {
            *place = value.to_bytes();
        }
        return;
    }
    store_bits::<T, OFFSET, BITS>(bytes, value);
}

/// The part of an image that begins with byte `OFFSET`: that of a PDO in the image of all.
#[inline]
pub fn part<P: ByteArray, const OFFSET: usize, const LENGTH: usize>(image: &[u8; LENGTH]) -> &P {
    const { assert!(OFFSET + P::LEN <= LENGTH, "the part does not lie in the image") };
    let bytes = image.get(OFFSET..).and_then(|bytes| bytes.get(..P::LEN));
    match bytes.map(P::from_slice) {
        Some(Ok(part)) => part,
        _ => inside(),
    }
}

/// The same to write to.
#[inline]
pub fn part_mut<P: ByteArray, const OFFSET: usize, const LENGTH: usize>(image: &mut [u8; LENGTH]) -> &mut P {
    const { assert!(OFFSET + P::LEN <= LENGTH, "the part does not lie in the image") };
    let bytes = image.get_mut(OFFSET..).and_then(|bytes| bytes.get_mut(..P::LEN));
    match bytes.map(P::from_slice_mut) {
        Some(Ok(part)) => part,
        _ => inside(),
    }
}

/// Parts of the same length in a row, the first of which begins with byte `OFFSET`: the PDOs of the axes.
#[inline]
pub fn row<const SIZE: usize, const COUNT: usize, const OFFSET: usize, const LENGTH: usize>(
    image: &[u8; LENGTH],
) -> &[[u8; SIZE]; COUNT] {
    const { assert!(OFFSET + SIZE * COUNT <= LENGTH, "the parts do not lie in the image") };
    let (parts, _) = image.get(OFFSET..).unwrap_or_default().as_chunks();
    match parts.first_chunk() {
        Some(parts) => parts,
        None => inside(),
    }
}

/// The same to write to.
#[inline]
pub fn row_mut<const SIZE: usize, const COUNT: usize, const OFFSET: usize, const LENGTH: usize>(
    image: &mut [u8; LENGTH],
) -> &mut [[u8; SIZE]; COUNT] {
    const { assert!(OFFSET + SIZE * COUNT <= LENGTH, "the parts do not lie in the image") };
    let (parts, _) = image.get_mut(OFFSET..).unwrap_or_default().as_chunks_mut();
    match parts.first_chunk_mut() {
        Some(parts) => parts,
        None => inside(),
    }
}

/// Where control never gets, as the place lies inside the image: that is asserted where this is called. Unlike a
/// panic it takes no machinery along where nothing is optimised.
fn inside<T>() -> T {
    loop {
        core::hint::spin_loop();
    }
}

/// Calls a function for a number of bytes that is known, so that each call is one of a constant length.
macro_rules! of_bytes {
    ($bytes:expr, $function:ident $arguments:tt: $($known:literal)+) => {
        match $bytes {
            $($known => $function::<$known>$arguments,)+
            _ => inside(),
        }
    };
}

/// Loads a value of at most 16 bytes that does not fill the bytes it has bits in.
#[inline]
fn load_bits<T: Value, const OFFSET: usize, const BITS: usize>(bytes: &[u8]) -> T {
    const { assert!(OFFSET % 8 + BITS <= 128, "a field of more than 15 bytes has to begin with a byte") };
    let touched = const { (OFFSET % 8 + BITS).div_ceil(8) };
    let window = of_bytes!(touched, window(bytes): 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);
    let number = extended::<T>(window.wrapping_shr(const { (OFFSET % 8) as u32 }), BITS);
    let value = number.to_le_bytes();
    match value.get(..T::SIZE).map(T::Bytes::from_slice) {
        Some(Ok(value)) => T::from_bytes(*value),
        _ => inside(),
    }
}

/// Stores a value of at most 16 bytes that does not fill the bytes it has bits in.
#[inline]
fn store_bits<T: Value, const OFFSET: usize, const BITS: usize>(bytes: &mut [u8], value: T) {
    const { assert!(OFFSET % 8 + BITS <= 128, "a field of more than 15 bytes has to begin with a byte") };
    let touched = const { (OFFSET % 8 + BITS).div_ceil(8) };
    let mut number = [0; 16];
    if let Some(Ok(place)) = number.get_mut(..T::SIZE).map(T::Bytes::from_slice_mut) {
        *place = value.to_bytes();
    }
    let number = extended::<T>(u128::from_le_bytes(number), 8 * T::SIZE);
    let (mask, shift) = const { (u128::MAX >> (128 - BITS), (OFFSET % 8) as u32) };
    let (number, mask) = ((number & mask).wrapping_shl(shift), mask.wrapping_shl(shift));
    of_bytes!(touched, merge(bytes, number, mask): 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);
}

/// The first bytes as a number.
#[inline]
fn window<const BYTES: usize>(bytes: &[u8]) -> u128 {
    let mut window = [0; 16];
    if let (Some(place), Some(bytes)) = (window.first_chunk_mut::<BYTES>(), bytes.first_chunk()) {
        *place = *bytes;
    }
    u128::from_le_bytes(window)
}

/// Puts the bits of a number that a mask names into the first bytes.
#[inline]
fn merge<const BYTES: usize>(bytes: &mut [u8], number: u128, mask: u128) {
    let merged = (window::<BYTES>(bytes) & !mask | number).to_le_bytes();
    if let (Some(place), Some(merged)) = (bytes.first_chunk_mut::<BYTES>(), merged.first_chunk()) {
        *place = *merged;
    }
}

/// The lowest bits of a number, and above them copies of the highest of these if the type has a sign.
#[inline]
fn extended<T: Value>(number: u128, bits: usize) -> u128 {
    let above = u32::try_from(128_usize.saturating_sub(bits)).unwrap_or(0);
    let top = number.wrapping_shl(above);
    if const { T::DATA_TYPE.is_signed() } {
        (top as i128).wrapping_shr(above) as u128
    } else {
        top.wrapping_shr(above)
    }
}
