//! What rules ask of a device again and again.

use crate::model::{
    Address, Configuration, Device, Entry, Index, Kind, Mapped, Object, Pdo, Place, Section, Value,
};

/// The objects that a description or a profile states; those that devc makes follow from what is judged
/// elsewhere.
pub(super) fn objects(device: &Device) -> impl Iterator<Item = &Object> {
    device.objects.iter().filter(|object| !object.derived)
}

/// The entries of these objects, with the object.
pub(super) fn entries(device: &Device) -> impl Iterator<Item = (&Object, &Entry)> {
    objects(device).flat_map(|object| object.entries.iter().map(move |entry| (object, entry)))
}

/// The objects that have this index on the first axis, one for each axis.
pub(super) fn on_axes(device: &Device, index: u16) -> impl Iterator<Item = &Object> {
    device.objects_of(Index(index)).filter(|object| !object.derived)
}

/// The place of an entry: that of the object alone if it has no other entry.
pub(super) fn name(object: &Object, entry: &Entry) -> Place {
    if object.entries.len() == 1 { object.index.into() } else { entry.address.into() }
}

/// Whether a key of an entry was set for all entries of its object.
pub(super) fn is_shared(object: &Object, entry: &Entry, key: &str) -> bool {
    let (own, all) = (entry.origin.node(key), object.origin.node(key));
    object.entries.len() > 1 && own.zip(all).is_some_and(|(own, all)| own.at == all.at)
}

/// What each PDO carries by default, and as configurations map it, with the place of each.
pub(super) fn mapped(device: &Device) -> impl Iterator<Item = (&Pdo, Place, &Mapped)> {
    let by_default = device.pdos.iter().flat_map(|pdo| mapped_of(pdo, None));
    let chosen = device.configurations.iter().flat_map(|configuration| {
        configuration.mapping.iter().flat_map(move |pdo| mapped_of(pdo, Some(configuration)))
    });
    by_default.chain(chosen)
}

/// What a PDO carries, with its place: in the mapping object, or in the configuration that maps the PDO so.
pub(super) fn mapped_of<'d>(
    pdo: &'d Pdo,
    configuration: Option<&'d Configuration>,
) -> impl Iterator<Item = (&'d Pdo, Place, &'d Mapped)> {
    let place = move |(subindex, item): (u8, usize)| match configuration {
        Some(configuration) => {
            Section::Configurations.at(&configuration.id).at(format!("mapping.{}.{item}", pdo.index))
        }
        None => Address { index: pdo.index, subindex }.into(),
    };
    (1..=u8::MAX).zip(0..).map(place).zip(&pdo.entries).map(move |(at, mapped)| (pdo, at, mapped))
}

/// Whether a number is greater than another.
pub(super) fn above(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Real(a), Value::Real(b)) => a > b,
        _ => matches!((a.integer(), b.integer()), (Some(a), Some(b)) if a > b),
    }
}

/// The limit that a value is beyond, the side of it that the value is on, and the key that says it: of the least and the
/// greatest, each with its key.
pub(super) fn beyond<'v>(
    value: &Value,
    [(min, min_key), (max, max_key)]: [(Option<&'v Value>, &'static str); 2],
) -> Option<(&'v Value, &'static str, &'static str)> {
    let low = min.filter(|min| above(min, value)).map(|min| (min, "below", min_key));
    low.or_else(|| max.filter(|max| above(value, max)).map(|max| (max, "above", max_key)))
}

/// The first value of an array and the first of another type: with the two, it is a record.
pub(super) fn of_two_types(object: &Object) -> Option<(&Entry, &Entry)> {
    let mut values = object.entries.iter().filter(|entry| entry.address.subindex > 0);
    let first = values.next().filter(|_| object.kind == Kind::Array)?;
    Some((first, values.find(|entry| entry.data_type != first.data_type)?))
}

/// The first and the last value of an entry if it says what each of its values means: two and more without gaps, and they
/// have no unit. A few special values among many are no list of all.
pub(super) fn all_values(entry: &Entry) -> Option<(i128, i128)> {
    let all = without_gaps(entry.values.iter().map(|meaning| (meaning.value, meaning.value)))?;
    (all.0 != all.1 && entry.unit.is_none()).then_some(all)
}

/// The first and the last value of ascending ranges, if one follows on the other.
pub(super) fn without_gaps(ranges: impl Iterator<Item = (i64, i64)>) -> Option<(i128, i128)> {
    let wide = ranges.map(|(first, last)| (i128::from(first), i128::from(last)));
    wide.map(Some).reduce(|all, next| {
        let ((first, last), next) = all.zip(next)?;
        (next.0 == last + 1).then_some((first, next.1))
    })?
}

/// Numbers as a list to read.
pub(super) fn list<T: ToString>(items: impl IntoIterator<Item = T>) -> String {
    items.into_iter().map(|item| item.to_string()).collect::<Vec<_>>().join(", ")
}

/// A sentence that names all there are: `the only mode is 8`, `the modes are 6, 8`.
pub(super) fn all<T: ToString>(noun: &str, items: impl IntoIterator<Item = T>) -> String {
    let items: Vec<T> = items.into_iter().collect();
    match items.as_slice() {
        [only] => format!("the only {noun} is {}", only.to_string()),
        _ => format!("the {noun}s are {}", list(items)),
    }
}

/// What a mapping refers to, if the dictionary has it.
pub(super) fn target<'d>(device: &'d Device, mapped: &Mapped) -> Option<(&'d Object, &'d Entry)> {
    let address = mapped.address?;
    let object = device.object(address.index)?;
    Some((object, object.entry(address.subindex)?))
}
