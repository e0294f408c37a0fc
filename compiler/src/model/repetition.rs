//! What is written once for all axes.

use super::{Device, Index, Object, Pdo, model};

model! {
    /// An object or a PDO that each axis has, or could have.
    pub struct Repetition by leading {
        /// The index of the one that was written, on the first axis.
        pub leading: Index,
        /// The index on each axis, in order; none where there is none.
        pub axes: Vec<Option<Index>>,
    }
}

/// What can be there once for each axis.
pub trait Repeated {
    /// Its index.
    fn index(&self) -> Index;

    /// The index of the one that was written for all axes; its own if it is there once.
    fn leading(&self) -> Index;

    /// The axis it belongs to, if it exists once for each.
    fn axis(&self) -> Option<u8>;

    /// Whether it stands for those of all axes, or for itself.
    fn is_leading(&self) -> bool {
        self.index() == self.leading()
    }
}

macro_rules! repeated {
    ($($name:ident)+) => {
        $(
            impl Repeated for $name {
                fn index(&self) -> Index {
                    self.index
                }

                fn leading(&self) -> Index {
                    self.leading
                }

                fn axis(&self) -> Option<u8> {
                    self.axis
                }
            }
        )+
    };
}
repeated! { Object Pdo }

/// What axes have, gathered by what was written for all of them.
pub(crate) fn repetitions<'r>(
    repeated: impl Iterator<Item = &'r dyn Repeated>,
    axes: usize,
) -> Vec<Repetition> {
    let mut found: std::collections::BTreeMap<Index, Vec<Option<Index>>> = Default::default();
    for one in repeated {
        let Some(axis) = one.axis() else { continue };
        let all = found.entry(one.leading()).or_insert_with(|| vec![None; axes]);
        if let Some(place) = all.get_mut(usize::from(axis)) {
            *place = Some(one.index());
        }
    }
    found.into_iter().map(|(leading, axes)| Repetition { leading, axes }).collect()
}

impl Device {
    /// The indices on the axes of what was written under this index for all of them; none if it is there once.
    pub fn repetition(&self, leading: Index) -> Option<&Repetition> {
        let place = self.repetitions.binary_search_by_key(&leading, |repetition| repetition.leading).ok()?;
        self.repetitions.get(place)
    }

    /// The objects that were written under this index: one for each axis, or one.
    pub fn objects_of(&self, leading: Index) -> impl Iterator<Item = &Object> {
        let axes = self.repetition(leading).map_or(&[][..], |repetition| &repetition.axes);
        let single = axes.is_empty().then_some(leading);
        axes.iter().copied().flatten().chain(single).filter_map(|index| self.object(index))
    }
}
