//! The two ways from a description to a device: generated Rust, and tables made while the program runs. A master cannot tell
//! which of them answers.
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing, clippy::unwrap_used)] // a test may

mod pair;

use std::path::Path;

use devc::model::{Device, Family};
use devc::source::Disk;
use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::cia402::Machine;
use devc_runtime::coe::{Information, ListKind, Operation, Request};
use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::{Operational, PreOperational, SafeOperational};
use devc_runtime::sdo::{Names, Values};
use devc_virtual::drive::Model;

use pair::{Pair, Whole};

fn family(name: &str) -> Family {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(name);
    let family = devc::compile(&Disk, &folder).family.expect("the description has no errors");
    (*family).clone()
}

/// Every address of a device, and some that it does not have.
fn addresses(device: &Device) -> Vec<Address> {
    let objects = device.objects.iter();
    let entries = objects.clone().flat_map(|object| object.entries.iter().map(|entry| entry.address));
    let behind = objects.map(|object| (object.index, object.highest_subindex().saturating_add(1)));
    let mut all: Vec<Address> = entries.map(|it| Address::new(it.index.0, it.subindex)).collect();
    all.extend(behind.map(|(index, subindex)| Address::new(index.0, subindex)));
    all.extend([0x0000, 0x1FFF, 0x5FFF, 0xFFFF].map(|index| Address::new(index, 0)));
    all
}

/// Values to write to an entry: the default, the ends of its range and what is beyond, and all lengths around its own.
fn values(device: &Device, address: Address) -> Vec<Vec<u8>> {
    let index = devc::model::Index(address.index);
    let Some(entry) = device.entry(devc::model::Address { index, subindex: address.subindex }) else {
        return vec![vec![0], vec![1, 2, 3, 4]];
    };
    let length = entry.data_type.bytes() as usize;
    let near = |value: &devc::model::Value, by: i128| {
        let near = value.integer().map(|value| value.wrapping_add(by)).unwrap_or_default();
        near.to_le_bytes()[..length.min(16)].to_vec()
    };
    let of_value = |value: &devc::model::Value| [-1, 0, 1].map(|by| near(value, by));
    let mut all: Vec<Vec<u8>> =
        [&entry.min, &entry.max, &entry.default].into_iter().flatten().flat_map(of_value).collect();
    all.extend(entry.default.as_ref().map(|value| value.little_endian(entry.data_type)));
    all.extend([0x00, 0x01, 0x55, 0x80, 0xFF].map(|byte| vec![byte; length]));
    all.extend([length.saturating_sub(1), length + 1, 0].map(|length| vec![0; length]));
    all
}

/// What is written, and what is left of it; in every state.
fn transfers_are_alike<V: Values>(pair: &mut Pair<V>, device: &Device, is_complete: bool) {
    for state in [PreOperational, SafeOperational, Operational] {
        pair.state = state;
        for address in addresses(device) {
            pair.upload(address, is_complete);
            for value in values(device, address) {
                pair.download(address, is_complete, &value);
            }
            pair.upload(address, is_complete);
        }
    }
}

fn descriptions_are_alike<V: Values>(pair: &mut Pair<V>, device: &Device) {
    for kind in [ListKind::Counts].into_iter().chain(ListKind::LISTS) {
        pair.inform(Information::new(Operation::GetList, &(kind as u16).to_le_bytes()));
        while pair.proceed() > 0 {}
    }
    for Address { index, subindex } in addresses(device) {
        let [low, high] = index.to_le_bytes();
        pair.inform(Information::new(Operation::GetObject, &[low, high]));
        for wanted in [0x00, 0x7F] {
            pair.inform(Information::new(Operation::GetEntry, &[low, high, subindex, wanted]));
        }
    }
}

/// Whole objects with data of their own length and of others.
fn whole_objects_are_alike<V: Values>(values: V, device: &Device) {
    let mut pair = Pair::new(Whole(values), Whole(Model::new(device).values()), None, 256);
    for state in [PreOperational, Operational] {
        pair.state = state;
        for object in &device.objects {
            for from in [0, 1, 2].map(|subindex| Address::new(object.index.0, subindex)) {
                let whole = pair.upload(from, true);
                for length in [whole.len(), whole.len() + 2, 1] {
                    pair.download(from, true, &vec![0; length]);
                }
                pair.download(from, true, &whole);
                pair.upload(from, true);
            }
        }
    }
}

fn answers_are_alike<V: Values + Copy>(
    values: V,
    names: Option<&'static Names>,
    machine: &Machine,
    device: &Device,
) {
    let model = Model::new(device);
    assert_eq!(model.machine(), machine, "{}", device.name);
    for size in [48, 512] {
        let mut pair = Pair::new(values, model.values(), names.zip(model.names()), size);
        descriptions_are_alike(&mut pair, device);
        transfers_are_alike(&mut pair, device, false);
        transfers_are_alike(&mut pair, device, true);
        descriptions_are_alike(&mut pair, device);
        assert!(pair.answers > 10 * device.objects.len(), "{} answers", pair.answers);
    }
    whole_objects_are_alike(values, device);
}

macro_rules! alike {
    ($($test:ident: $family:literal $($module:ident)::+, $names:expr;)+) => {$(
        #[test]
        fn $test() {
            let family = family($family);
            let id = stringify!($test).replace('_', "-");
            let device = family.members.iter().find(|device| device.id == id).expect("it is a member");
            let names: Option<&'static Names> = $names;
            assert_eq!(names.is_some(), Model::new(device).names().is_some());
            answers_are_alike($($module)::+::dictionary::Dictionary::DEFAULT, names, &$($module)::+::MACHINE, device);
        }
    )+};
}

alike! {
    c887: "c887" c887, Some(&c887::dictionary::NAMES);
    s300: "s700" s700::s300, None;
    s400: "s700" s700::s400, None;
    s600: "s700" s700::s600, None;
    s700: "s700" s700::s700, None;
    double: "pmc-sc6" pmc_sc6::double, Some(&pmc_sc6::double::dictionary::NAMES);
    single: "pmc-sc6" pmc_sc6::single, Some(&pmc_sc6::single::dictionary::NAMES);
    double_hires: "pmc-sc6" pmc_sc6::double_hires, None;
    single_hires: "pmc-sc6" pmc_sc6::single_hires, None;
}

#[test]
fn what_differs_is_seen() {
    let family = family("c887");
    let mut pair =
        Pair::new(c887::dictionary::Dictionary::DEFAULT, Model::new(&family.members[0]).values(), None, 64);
    let request = Request::Upload { address: Address::new(0x6040, 0), is_complete: false };
    pair.made.server.values = {
        let mut other = pair.made.clone();
        let written = other.server.download(Address::new(0x6040, 0), PreOperational, &[1, 0]);
        assert_eq!(written, Ok(()));
        other.server.values
    };
    let (generated, made) = pair.answers_to(request);
    assert_ne!(generated, made);
}
