//! Values anywhere between the bits of an image.

/// Eight bits from a bit on; behind the image they are 0.
fn byte(image: &[u8], offset: usize) -> u8 {
    let at = |place: usize| image.get(place).copied().unwrap_or(0);
    let (first, shift) = (offset / 8, offset % 8);
    let [byte, _] = (u16::from_le_bytes([at(first), at(first.saturating_add(1))]) >> shift).to_le_bytes();
    byte
}

/// Loads so many bits from a bit on into the lowest of a value; its others are 0.
pub(super) fn load(image: &[u8], offset: usize, width: usize, value: &mut [u8]) {
    for (place, to) in value.iter_mut().enumerate() {
        let done = place.saturating_mul(8);
        *to = byte(image, offset.saturating_add(done)) & mask(width.saturating_sub(done));
    }
}

/// Stores so many of the lowest bits of a value from a bit on; those that the value lacks are 0.
pub(super) fn store(image: &mut [u8], offset: usize, width: usize, value: &[u8]) {
    for (place, done) in (0..width).step_by(8).enumerate() {
        let mask = mask(width.saturating_sub(done));
        let (at, shift) = (offset.saturating_add(done) / 8, offset % 8);
        let bits = u16::from(value.get(place).copied().unwrap_or(0) & mask) << shift;
        let mask = u16::from(mask) << shift;
        let parts = bits.to_le_bytes().into_iter().zip(mask.to_le_bytes());
        for (to, (bits, mask)) in image.get_mut(at..).unwrap_or_default().iter_mut().zip(parts) {
            *to = *to & !mask | bits;
        }
    }
}

/// Fills the bits above so many with the highest of these.
pub(super) fn extend(value: &mut [u8], width: usize) {
    let Some(last) = width.checked_sub(1) else { return };
    if byte(value, last) & 1 == 0 {
        return;
    }
    for (place, to) in value.iter_mut().enumerate() {
        *to |= !mask(width.saturating_sub(place.saturating_mul(8)));
    }
}

/// The lowest of eight bits.
fn mask(bits: usize) -> u8 {
    if bits >= 8 { u8::MAX } else { !(u8::MAX << bits) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_lie_at_any_bit() {
        for offset in 0..17 {
            for width in 1..=24 {
                let mut image = [0xA5; 6];
                let value = 0x00C3_5A96_u32 & (u32::MAX >> (32 - width));
                store(&mut image, offset, width, &value.to_le_bytes());
                let [a, b, c, d, e, f] = image;
                let whole = u64::from_le_bytes([a, b, c, d, e, f, 0, 0]);
                assert_eq!(whole >> offset & (u64::MAX >> (64 - width)), value.into(), "{offset}, {width}");
                let around = !((u64::MAX >> (64 - width)) << offset) & 0xFFFF_FFFF_FFFF;
                assert_eq!(whole & around, 0xA5A5_A5A5_A5A5 & around, "{offset}, {width}");
                let mut back = [0xFF; 4];
                load(&image, offset, width, &mut back);
                assert_eq!(u32::from_le_bytes(back), value);
                extend(&mut back, width);
                let signed = (value << (32 - width)) as i32 >> (32 - width);
                assert_eq!(i32::from_le_bytes(back), signed, "{offset}, {width}");
            }
        }
    }
}
