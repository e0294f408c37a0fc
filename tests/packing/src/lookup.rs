//! Looking up an entry of the C-887's dictionary by its address.

use std::collections::HashMap;
use std::hint::black_box;

use devc_runtime::object::Address;
use devc_runtime::sdo::EntryInfo;

use crate::Task;
use crate::c887::dictionary::TABLE;

/// How often each address is looked up for a round of the other subjects.
pub fn run(task: &Task) {
    let entries = entries();
    let sorted: Vec<(u32, &EntryInfo)> =
        entries.iter().map(|(address, entry)| (key(*address), *entry)).collect();
    let hashed: HashMap<u32, &EntryInfo> = sorted.iter().copied().collect();
    let mut asked: Vec<Address> = entries.iter().map(|(address, _)| *address).collect();
    shuffle(&mut asked);
    let mut next = asked.iter().copied().cycle();
    let mut address = move || black_box(next.next().unwrap_or(Address::new(0, 0)));
    task.subject("nothing, lookup", || {
        black_box(address());
    });
    task.subject("devc, lookup", || {
        black_box(found(address()));
    });
    task.subject("binary search, lookup", || {
        let key = key(address());
        black_box(
            sorted.binary_search_by_key(&key, |(key, _)| *key).ok().and_then(|place| sorted.get(place)),
        );
    });
    task.subject("hash map, lookup", || {
        black_box(hashed.get(&key(address())));
    });
}

#[inline(never)]
fn found(address: Address) -> Option<&'static EntryInfo> {
    TABLE.find(address).ok().map(|found| found.entry)
}

fn key(address: Address) -> u32 {
    u32::from(address.index) << 8 | u32::from(address.subindex)
}

fn entries() -> Vec<(Address, &'static EntryInfo)> {
    let of = |(index, object): (u16, &'static devc_runtime::sdo::ObjectInfo)| {
        object.entries.iter().map(move |entry| (Address::new(index, entry.subindex), entry))
    };
    TABLE.objects().flat_map(of).collect()
}

/// The same order each time, with nothing to predict.
fn shuffle(addresses: &mut [Address]) {
    let mut state = 1_u64;
    for place in (1..addresses.len()).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        addresses.swap(place, (state >> 33) as usize % (place + 1));
    }
}
