//! The bytes that a value has bits in.

/// Bits of a value that lie in one byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::emit) struct Piece {
    /// The byte.
    pub(in crate::emit) byte: u32,
    /// The lowest of them in the byte.
    pub(in crate::emit) in_byte: u32,
    /// The lowest of them in the value.
    pub(in crate::emit) in_value: u32,
    /// How many there are.
    pub(in crate::emit) bits: u32,
}

impl Piece {
    /// Its bits, lowest first.
    pub(in crate::emit) fn mask(self) -> u32 {
        (1 << self.bits) - 1
    }
}

/// The pieces of a value of so many bits that begins at a bit.
pub(in crate::emit) fn pieces(at: u32, bits: u32) -> impl Iterator<Item = Piece> {
    let end = at + bits;
    (at / 8..end.div_ceil(8)).map(move |byte| {
        let (low, high) = (at.max(byte * 8), end.min(byte * 8 + 8));
        Piece { byte, in_byte: low - byte * 8, in_value: low - at, bits: high - low }
    })
}

#[cfg(test)]
mod tests {
    use super::{Piece, pieces};

    #[test]
    fn a_value_is_taken_apart_at_bytes() {
        let piece = |byte, in_byte, in_value, bits| Piece { byte, in_byte, in_value, bits };
        let found: Vec<Piece> = pieces(6, 11).collect();
        assert_eq!(found, [piece(0, 6, 0, 2), piece(1, 0, 2, 8), piece(2, 0, 10, 1)]);
        assert_eq!(pieces(16, 8).collect::<Vec<_>>(), [piece(2, 0, 0, 8)]);
        assert_eq!(pieces(16, 0).count(), 0);
    }
}
