//! Sequences of several members brought into one, in order.

/// What some members have in common: each with its own copy of it. Never empty.
pub(super) struct Unit<T> {
    /// The members by number, in order, with what each has.
    pub(super) items: Vec<(usize, T)>,
}

impl<T> Unit<T> {
    /// The members by number.
    pub(super) fn members(&self) -> Vec<usize> {
        self.items.iter().map(|(member, _)| *member).collect()
    }

    fn takes(&self, member: usize, item: &T, same: impl Fn(&T, &T) -> bool) -> bool {
        self.items.iter().all(|(other, own)| *other != member && same(own, item))
    }
}

/// Brings the sequences of members into one. What is `same` becomes one unit; what a member has alone stands
/// behind what is `akin` to it, or else before what it shares next.
pub(super) fn align<T>(
    sequences: impl IntoIterator<Item = (usize, Vec<T>)>,
    same: impl Fn(&T, &T) -> bool,
    akin: impl Fn(&T, &T) -> bool,
) -> Vec<Unit<T>> {
    let mut units: Vec<Unit<T>> = Vec::new();
    for (member, sequence) in sequences {
        let mut next = units.len();
        for item in sequence.into_iter().rev() {
            // most sequences go on where the others do
            let takes = |unit: &Unit<T>| unit.takes(member, &item, &same);
            let expected = next.checked_sub(1).filter(|place| units.get(*place).is_some_and(takes));
            let found = expected.or_else(|| units.iter().rposition(takes));
            if let Some((place, unit)) = found.and_then(|place| Some((place, units.get_mut(place)?))) {
                unit.items.push((member, item));
                next = place;
                continue;
            }
            let like = |unit: &Unit<T>| unit.takes(member, &item, &akin);
            next = units.iter().rposition(like).map_or(next, |place| place + 1);
            units.insert(next.min(units.len()), Unit { items: vec![(member, item)] });
        }
    }
    units
}

#[cfg(test)]
mod tests {
    use super::*;

    fn aligned(sequences: [&[&'static str]; 2]) -> Vec<(&'static str, Vec<usize>)> {
        let sequences = sequences.into_iter().map(<[&str]>::to_vec).enumerate();
        let akin = |one: &&str, other: &&str| one.get(..1) == other.get(..1);
        let units = align(sequences, |one, other| one == other, akin);
        units.iter().filter_map(|unit| Some((unit.items.first()?.1, unit.members()))).collect()
    }

    #[test]
    fn what_is_the_same_stands_once_and_in_order() {
        let both = vec![0, 1];
        assert_eq!(
            aligned([&["a", "b", "d"], &["a", "c", "d", "e"]]),
            [("a", both.clone()), ("b", vec![0]), ("c", vec![1]), ("d", both), ("e", vec![1])]
        );
    }

    #[test]
    fn what_one_member_has_stays_in_its_order() {
        assert_eq!(
            aligned([&["x", "a1", "a2"], &["x", "a1", "a2"]]),
            [("x", vec![0, 1]), ("a1", vec![0, 1]), ("a2", vec![0, 1])]
        );
    }

    #[test]
    fn versions_of_the_same_thing_stand_together() {
        assert_eq!(
            aligned([&["a1", "b1"], &["a2", "b2"]]),
            [("a1", vec![0]), ("a2", vec![1]), ("b1", vec![0]), ("b2", vec![1])]
        );
    }
}
