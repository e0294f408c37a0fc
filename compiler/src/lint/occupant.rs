//! What is in the slot of an axis, as an ESI tells it of the module.

use std::collections::{BTreeMap, BTreeSet};

use crate::model::{Address, Axis, DataType, Device, Index, Module, Object, Pdo, differences};
use crate::source::Location;

/// What an axis has in its slot: objects and PDOs by their index on the first axis.
#[derive(Debug, Clone)]
pub(crate) struct Occupant {
    /// The number of the module.
    pub(crate) module: u32,
    /// The name of the axis.
    pub(crate) axis: String,
    header: Location,
    name: String,
    objects: BTreeMap<Index, Object>,
    pdos: BTreeMap<Index, Carried>,
}

/// What an ESI tells of a PDO beside its index.
#[derive(Debug, Clone)]
struct Carried {
    index: Index,
    at: Location,
    entries: Vec<(Option<Address>, u32, Option<DataType>, String)>,
    is_fixed: bool,
    is_mandatory: bool,
    manager: Option<u8>,
}

impl Occupant {
    /// What an axis has that is such a module.
    pub(crate) fn new(device: &Device, module: &Module, axis: &Axis) -> Self {
        let on_axis = || {
            let all = device.repetitions.iter();
            all.filter_map(|all| Some((all.leading, (*all.axes.get(usize::from(axis.number))?)?)))
        };
        let object = |(leading, index)| {
            let object = device.object(index)?;
            device.slot_of(object).map(|_| (leading, object.clone()))
        };
        let pdo = |(leading, index)| Some((leading, Carried::new(device, device.pdo(index)?)));
        Self {
            module: module.ident,
            axis: axis.name.clone(),
            header: module.origin.header(),
            name: module.name.clone(),
            objects: on_axis().filter_map(object).collect(),
            pdos: on_axis().filter_map(pdo).collect(),
        }
    }
}

impl Carried {
    fn new(device: &Device, pdo: &Pdo) -> Self {
        let axis = pdo.axis.unwrap_or_default();
        let leading = |index| device.index_in_slot(axis, index).unwrap_or(index);
        let entries = pdo.entries.iter().map(|mapped| {
            let address = mapped.address.map(|it| Address { index: leading(it.index), ..it });
            (address, mapped.bits, mapped.data_type, mapped.name.clone())
        });
        Self {
            index: pdo.index,
            at: pdo.origin.header(),
            entries: entries.collect(),
            is_fixed: pdo.fixed,
            is_mandatory: pdo.mandatory,
            manager: device.manager_of(pdo).map(|manager| manager.number),
        }
    }

    fn is_like(&self, other: &Self) -> bool {
        self.entries == other.entries
            && (self.is_fixed, self.is_mandatory, self.manager)
                == (other.is_fixed, other.is_mandatory, other.manager)
    }
}

/// The first thing in which two are not alike, and where it stands; by the names of those that have them.
pub(crate) fn unlike([one, other]: [&Occupant; 2], names: [&str; 2]) -> Option<(String, Location)> {
    if one.name != other.name {
        return Some((format!("it is `{}` there and `{}` here", one.name, other.name), other.header));
    }
    let indices: BTreeSet<Index> =
        [one, other].into_iter().flat_map(|it| it.objects.keys().chain(it.pdos.keys())).copied().collect();
    let lacks = |name, index, at| Some((format!("`{name}` has no {index}"), at));
    let [first, second] = names;
    indices.into_iter().find_map(|index| {
        let of_objects = match (one.objects.get(&index), other.objects.get(&index)) {
            (Some(mine), Some(same)) => objects(mine, same),
            (Some(mine), None) => lacks(second, index, mine.origin.header()),
            (None, Some(same)) => lacks(first, index, same.origin.header()),
            (None, None) => None,
        };
        of_objects.or_else(|| match (one.pdos.get(&index), other.pdos.get(&index)) {
            (Some(mine), Some(same)) => pdos(mine, same),
            (Some(mine), None) => lacks(second, index, mine.at),
            (None, Some(same)) => lacks(first, index, same.at),
            (None, None) => None,
        })
    })
}

/// Fields that the ESI does not have, or that tell the axis.
const BESIDE: &[&str] = &[
    "index",
    "address",
    "axis",
    "id",
    "about",
    "note",
    "source",
    "parameter",
    "unit",
    "functional",
    "trigger",
    "entries",
    "excludes",
];

fn objects(one: &Object, other: &Object) -> Option<(String, Location)> {
    if one.entries.len() != other.entries.len() {
        return Some((
            format!("{} and {} have not the same entries", one.index, other.index),
            other.origin.header(),
        ));
    }
    let entries = one.entries.iter().zip(&other.entries);
    let of_entries = entries.flat_map(|(one, other)| {
        let found = differences(one, other).into_iter();
        found.map(move |difference| (one.address.to_string(), other.address.to_string(), difference))
    });
    let whole = differences(one, other).into_iter();
    let whole = whole.map(|difference| (one.index.to_string(), other.index.to_string(), difference));
    let mut found = whole.chain(of_entries).filter(|(_, _, difference)| {
        difference.path.0.first().is_some_and(|field| !BESIDE.contains(&&**field))
    });
    found.next().map(|(one, same, difference)| {
        let field = difference.path.to_string().replace('_', " ");
        let at = difference.second_at.unwrap_or(other.origin.header());
        (format!("the {field} of {one} is not that of {same}"), at)
    })
}

fn pdos(one: &Carried, other: &Carried) -> Option<(String, Location)> {
    let what = || format!("{} and {} differ in more than their indices", one.index, other.index);
    (!one.is_like(other)).then(|| (what(), other.at))
}
