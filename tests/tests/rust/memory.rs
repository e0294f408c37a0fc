//! What a dictionary takes of a device's memory.

use std::collections::BTreeSet;

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::object::Address;
use devc_runtime::sdo::{Dictionary, Values};

/// Bytes of a page, an object and an entry where pointers and lengths have four: their fields, filled up to what is
/// aligned.
const PAGE: usize = 20;
const OBJECT: usize = 16;
const ENTRY: usize = 8;

/// Bytes of the table in flash, where equal lists of entries are one, as the linker has them.
fn flash(table: &Dictionary) -> (usize, usize) {
    let (mut slots, mut objects, mut entries) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    let mut bytes = table.directory.len() + PAGE * table.pages.len();
    for page in table.pages {
        let text = format!("{:?}", page.objects);
        bytes += if slots.insert((page.slots, text.clone())) { page.slots.len() } else { 0 };
        bytes += if objects.insert(text) { OBJECT * page.objects.len() } else { 0 };
        for object in page.objects {
            let is_new = entries.insert(format!("{:?}", object.entries));
            bytes += if is_new { ENTRY * object.entries.len() } else { 0 };
        }
    }
    (bytes, table.objects().map(|(_, object)| object.entries.len()).sum())
}

#[test]
fn an_entry_takes_at_most_thirteen_bytes_of_flash() {
    let tables = [
        &c887::dictionary::TABLE,
        &s700::s300::dictionary::TABLE,
        &s700::s700::dictionary::TABLE,
        &pmc_sc6::double::dictionary::TABLE,
        &pmc_sc6::double_hires::dictionary::TABLE,
    ];
    for (bytes, entries) in tables.map(flash) {
        assert!(bytes <= 13 * entries, "{bytes} bytes for {entries} entries");
    }
}

/// Bytes of the values that change, a text counted as the reference that is kept of it.
fn kept(values: &impl Values) -> usize {
    let table = values.table();
    let entries = table.objects().flat_map(|(index, object)| {
        object.entries.iter().filter_map(move |entry| table.find(Address::new(index, entry.subindex)).ok())
    });
    let kept =
        entries.filter(|found| found.place().is_some()).map(|found| match found.entry.data_type.is_text() {
            true => size_of::<&str>(),
            false => usize::from(found.entry.bytes()),
        });
    kept.sum()
}

fn takes_its_values<V: Values>(values: V) {
    let (bytes, struct_bytes) = (kept(&values), size_of::<V>());
    // numbers of four bytes lie at multiples of four, so records end with up to three that are not used
    assert!(struct_bytes >= bytes && struct_bytes <= bytes + bytes / 8, "{struct_bytes} bytes for {bytes}");
}

#[test]
fn a_dictionary_takes_its_values_of_ram() {
    takes_its_values(c887::dictionary::Dictionary::DEFAULT);
    takes_its_values(s700::s700::dictionary::Dictionary::DEFAULT);
    takes_its_values(pmc_sc6::double::dictionary::Dictionary::DEFAULT);
}
