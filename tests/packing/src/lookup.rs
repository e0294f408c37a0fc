//! Looking up an entry by its address: in the C-887's dictionary against other ways, and in dictionaries that grow.

use std::collections::HashMap;
use std::hint::black_box;
use std::iter::{Copied, Cycle};
use std::slice::Iter;

use devc_runtime::object::Address;
use devc_runtime::sdo::{
    Access, DataType, Dictionary, EntryInfo, NONE, ObjectCode, ObjectInfo, Page, positions,
};

use crate::Task;
use crate::c887::dictionary::TABLE;

/// Everything is made before the first subject, so that only lookups are counted.
pub fn run(task: &Task) {
    let entries = entries(&TABLE);
    let addresses: Vec<Address> = entries.iter().map(|(address, _)| *address).collect();
    let mut known = shuffled(addresses.iter().copied());
    let mut no_entry = shuffled(addresses.iter().map(|address| Address::new(address.index, 200)));
    let mut no_object = shuffled(addresses.iter().map(|address| Address::new(address.index ^ 0x80, 0)));
    let dictionaries = [("300", grown(1, 20)), ("30 000", grown(20, 100))];
    let sorted: Vec<(u32, &EntryInfo)> =
        entries.iter().map(|(address, entry)| (key(*address), *entry)).collect();
    let hashed: HashMap<u32, &EntryInfo> = sorted.iter().copied().collect();
    task.subject("nothing, lookup", || {
        black_box(next(&mut known));
    });
    task.subject("devc, lookup", || {
        black_box(found(next(&mut known)));
    });
    task.subject("devc, no such entry, lookup", || {
        black_box(found(next(&mut no_entry)));
    });
    task.subject("devc, no such object, lookup", || {
        black_box(found(next(&mut no_object)));
    });
    for (count, (table, mut addresses)) in dictionaries {
        task.subject(&format!("devc, any of {count}, lookup"), || {
            black_box(found_in(&table, next(&mut addresses)));
        });
    }
    task.subject("binary search, lookup", || {
        let key = key(next(&mut known));
        black_box(
            sorted.binary_search_by_key(&key, |(key, _)| *key).ok().and_then(|place| sorted.get(place)),
        );
    });
    task.subject("hash map, lookup", || {
        black_box(hashed.get(&key(next(&mut known))));
    });
}

/// A firmware knows its table when it is compiled.
#[inline(never)]
fn found(address: Address) -> Option<&'static EntryInfo> {
    TABLE.find(address).ok().map(|found| found.entry)
}

#[inline(never)]
fn found_in(table: &Dictionary, address: Address) -> Option<&'static EntryInfo> {
    table.find(address).ok().map(|found| found.entry)
}

/// A dictionary of so many pages, each with so many objects of 15 entries, and its addresses.
fn grown(pages: usize, objects: u8) -> (Dictionary, Addresses) {
    const ENTRIES: &[EntryInfo] = &EntryInfo::list::<15>(0, DataType::INTEGER32, 32, Access::READ);
    let object = ObjectInfo { code: ObjectCode::Array, axis: 0, field: 0, entries: ENTRIES, constants: 0 };
    let lows: Vec<u8> = (0..objects).collect();
    let slots: &'static [u8; 256] = Box::leak(Box::new(positions(0, &lows)));
    let page = Page { first: 0, axis: 0, slots, objects: vec![object; objects.into()].leak() };
    let mut directory = [NONE; 256];
    for (page, position) in directory.iter_mut().skip(0x20).take(pages).zip(0..) {
        *page = position;
    }
    let directory = Box::leak(Box::new(directory));
    let table = Dictionary { directory, pages: vec![page; pages].leak(), constants: &[] };
    let addresses = shuffled(entries(&table).into_iter().map(|(address, _)| address));
    (table, addresses)
}

fn key(address: Address) -> u32 {
    u32::from(address.index) << 8 | u32::from(address.subindex)
}

fn entries(table: &Dictionary) -> Vec<(Address, &'static EntryInfo)> {
    let of = |(index, object): (u16, &'static ObjectInfo)| {
        object.entries.iter().map(move |entry| (Address::new(index, entry.subindex), entry))
    };
    table.objects().flat_map(of).collect()
}

/// One address after another, without end.
type Addresses = Cycle<Copied<Iter<'static, Address>>>;

/// The same order each time, with nothing to predict.
fn shuffled(addresses: impl Iterator<Item = Address>) -> Addresses {
    let mut addresses: Vec<Address> = addresses.collect();
    let mut state = 1_u64;
    for place in (1..addresses.len()).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        addresses.swap(place, (state >> 33) as usize % (place + 1));
    }
    addresses.leak().iter().copied().cycle()
}

/// What each subject costs besides looking up.
#[inline(never)]
fn next(addresses: &mut Addresses) -> Address {
    addresses.next().unwrap_or(Address::new(0, 0))
}
