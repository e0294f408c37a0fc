//! What shares numbers with something that begins before it.

/// The items whose first number lies in one before them, each behind the one that reaches furthest; in the order in which
/// they begin. A range has its first number and its last.
pub(super) fn overlapping<T, N: Ord + Copy>(items: &[T], range: impl Fn(&T) -> (N, N)) -> Vec<(&T, &T)> {
    let mut items: Vec<&T> = items.iter().collect();
    items.sort_by_key(|item| range(item));
    let mut furthest: Option<&T> = None;
    let mut found = Vec::new();
    for item in items {
        let (first, last) = range(item);
        found.extend(furthest.filter(|other| first <= range(other).1).map(|other| (other, item)));
        if furthest.is_none_or(|other| range(other).1 < last) {
            furthest = Some(item);
        }
    }
    found
}
