//! Values of which some are in use.

/// The values of an object whose subindex 0 can be written: it says how many of the others are in use.
///
/// ```
/// use devc_runtime::sdo::List;
///
/// let mut assigned = List { count: 1, items: [0x1600_u16, 0x1601] };
/// assert_eq!(assigned.in_use(), [0x1600]);
/// assigned.count = 2;
/// assert_eq!(assigned.in_use(), [0x1600, 0x1601]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct List<T, const N: usize> {
    /// Subindex 0.
    pub count: u8,
    /// The values from subindex 1 on.
    pub items: [T; N],
}

impl<T, const N: usize> List<T, N> {
    /// Those in use.
    pub fn in_use(&self) -> &[T] {
        self.items.get(..usize::from(self.count)).unwrap_or(&self.items)
    }

    /// The value at a subindex from 1 on, for generated code.
    pub fn item(&mut self, subindex: u8) -> Option<&mut T> {
        self.items.get_mut(usize::from(subindex).checked_sub(1)?)
    }
}
