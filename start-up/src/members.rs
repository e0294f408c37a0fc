//! Which members of a family have something.

/// Members of a family, by their places in the list of a family.
///
/// ```
/// use devc_start_up::Members;
///
/// let members = Members::of(&[0, 3]);
/// assert!(members.has(3) && !members.has(2));
/// assert!(Members::ALL.has(2));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Members(Option<&'static [u16]>);

impl Members {
    /// Every member; the only one of a device that is alone.
    pub const ALL: Self = Self(None);

    /// The members at these places.
    pub const fn of(places: &'static [u16]) -> Self {
        Self(Some(places))
    }

    /// Whether the member at this place is one of them.
    pub const fn has(self, member: u16) -> bool {
        let Some(mut places) = self.0 else { return true };
        while let Some((place, rest)) = places.split_first() {
            if *place == member {
                return true;
            }
            places = rest;
        }
        false
    }
}
