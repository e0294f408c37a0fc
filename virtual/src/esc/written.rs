//! What is to be written.

/// Data to be written; with a mask, only the bits that are set in it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Written<'d> {
    data: &'d [u8],
    mask: Option<&'d [u8]>,
}

impl<'d> Written<'d> {
    /// All bits.
    pub(crate) const fn all(data: &'d [u8]) -> Self {
        Self { data, mask: None }
    }

    pub(crate) const fn masked(data: &'d [u8], mask: &'d [u8]) -> Self {
        Self { data, mask: Some(mask) }
    }

    pub(crate) const fn len(self) -> usize {
        self.data.len()
    }

    /// So many bytes from a place on; less where there are not so many.
    pub(crate) fn part(self, from: usize, length: usize) -> Self {
        let of = |bytes: &'d [u8]| {
            let rest = bytes.get(from..).unwrap_or_default();
            rest.get(..length).unwrap_or(rest)
        };
        Self { data: of(self.data), mask: self.mask.map(of) }
    }

    /// Writes it, as far as there is room.
    pub(crate) fn store(self, into: &mut [u8]) {
        match self.mask {
            None => into.iter_mut().zip(self.data).for_each(|(to, from)| *to = *from),
            Some(mask) => {
                for ((to, from), mask) in into.iter_mut().zip(self.data).zip(mask) {
                    *to = *to & !mask | from & mask;
                }
            }
        }
    }
}
