//! The start-up list of every configuration of every shipped device, write by write through its mailbox.

use std::path::Path;

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::coe::Mailbox;
use devc_runtime::pdo::ProcessData;
use devc_runtime::sdo::{Server, Values};
use devc_runtime::start_up::{StartUp, Write};
use serde_json::Value;

use crate::mapped::write;

/// The lists of a member, with the words for them, from the model as JSON.
fn lists(family: &str, member: &str) -> Vec<(String, Vec<Value>)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../generated/{family}/{family}.json"));
    let text = std::fs::read_to_string(path).expect("the output is there");
    let json: Value = serde_json::from_str(&text).expect("it is JSON");
    let members = json["members"].as_array().expect("there are members");
    let member = members.iter().find(|it| it["id"] == member).expect("there is such a member");
    let lists = member["configurations"].as_array().expect("there is a list").iter().map(|configuration| {
        let id = configuration["id"].as_str().expect("it has one").to_owned();
        (id, configuration["startup"].as_array().expect("it has one").clone())
    });
    lists.collect()
}

fn number<T: TryFrom<u64>>(value: &Value) -> T {
    let number = value.as_u64().expect("it is a number");
    T::try_from(number).unwrap_or_else(|_| panic!("{number} is too large"))
}

/// Plays all lists of a member, each on a device as delivered, and tells how many writes that were.
fn play<V: Values>(values: impl Fn() -> V, family: &str, member: &str) -> usize {
    let mut played = 0;
    for (id, writes) in lists(family, member) {
        let mut mailbox = Mailbox::new(Server::new(values(), ()));
        for it in &writes {
            let to = (number(&it["address"]["index"]), number(&it["address"]["subindex"]));
            let data: Vec<u8> = it["data"].as_array().expect("it has some").iter().map(number).collect();
            let written = write(&mut mailbox, to, &data);
            assert_eq!(written, Ok(()), "{member}, {id}: {}", it["comment"]);
            played += 1;
        }
    }
    played
}

#[test]
fn each_configuration_is_accepted() {
    use c887::dictionary::Dictionary;
    assert!(play(|| Dictionary::DEFAULT, "c887", "c887") > 15);
    assert!(play(|| s700::s300::dictionary::Dictionary::DEFAULT, "s700", "s300") > 15);
    assert!(play(|| s700::s400::dictionary::Dictionary::DEFAULT, "s700", "s400") > 2);
    assert!(play(|| s700::s600::dictionary::Dictionary::DEFAULT, "s700", "s600") > 2);
    assert!(play(|| s700::s700::dictionary::Dictionary::DEFAULT, "s700", "s700") > 15);
    assert!(play(|| pmc_sc6::double::dictionary::Dictionary::DEFAULT, "pmc-sc6", "double") > 5);
    assert!(play(|| pmc_sc6::single::dictionary::Dictionary::DEFAULT, "pmc-sc6", "single") > 2);
    assert!(play(|| pmc_sc6::double_hires::dictionary::Dictionary::DEFAULT, "pmc-sc6", "double-hires") > 5);
    assert!(play(|| pmc_sc6::single_hires::dictionary::Dictionary::DEFAULT, "pmc-sc6", "single-hires") > 2);
}

/// The same lists as generated Rust has them, and the order of the example in the manual (S700, 3.6.1).
#[test]
fn the_free_mapping_of_the_s700_is_accepted() {
    let mut mailbox = Mailbox::new(Server::new(s700::s700::dictionary::Dictionary::DEFAULT, ()));
    for it in s700::s700::configurations::FREE_MAPPING {
        let to = (it.address.index, it.address.subindex);
        assert_eq!(write(&mut mailbox, to, it.data()), Ok(()), "{it}");
    }
    let values = &mailbox.server.values;
    assert_eq!(values.rx_pdo_1600.in_use(), [0x6040_0010, 0x60C1_0020]);
    assert_eq!(values.tx_pdo_1a00.in_use(), [0x6041_0010, 0x6063_0020]);
    assert_eq!(values.sync_manager_2_pdo_assignment.in_use(), [0x1600]);
}

/// The process data of a configuration has types, and the list that follows from them is one that the device accepts.
#[test]
fn the_list_of_the_types_of_a_configuration_is_accepted() {
    use s700::s700::configurations::{free_mapping, position};
    const FREE: StartUp =
        StartUp::of::<free_mapping::Outputs, free_mapping::Inputs>().mode(1).cycle_ns::<2_000_000>();
    const FIXED: StartUp = StartUp::of::<position::Outputs, position::Inputs>();
    assert_eq!((free_mapping::Outputs::LEN, free_mapping::Inputs::LEN), (6, 6));
    let lists: [Vec<Write>; 2] =
        [FREE.writes::<{ FREE.len() }>().to_vec(), FIXED.writes::<{ FIXED.len() }>().to_vec()];
    let assigned = lists.map(|list| {
        let mut mailbox = Mailbox::new(Server::new(s700::s700::dictionary::Dictionary::DEFAULT, ()));
        for it in list {
            let to = (it.address.index, it.address.subindex);
            assert_eq!(write(&mut mailbox, to, it.data()), Ok(()), "{it}");
        }
        mailbox.server.values.sync_manager_2_pdo_assignment.in_use().to_vec()
    });
    assert_eq!(assigned, [[0x1600], [0x1701]]);
}

/// Pilz, Tab. 18 to 21: 5 bytes and 5 bytes for each axis.
#[test]
fn the_velocity_mapping_of_the_pmc_has_types() {
    use pmc_sc6::{double::configurations::velocity as two, single::configurations::velocity as one};
    assert_eq!((two::Outputs::LEN, two::Inputs::LEN), (10, 10));
    assert_eq!((one::Outputs::LEN, one::Inputs::LEN), (5, 5));
    let image = one::RxPdo1600 { vl_target_velocity: -2, ..one::RxPdo1600::unpack([0; 5]) }.pack();
    assert_eq!(image, [0, 0, 0, 0xFE, 0xFF]);
}
