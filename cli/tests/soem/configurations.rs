//! Every configuration that is shipped, written by SOEM: it reads from the device what it has made of it.

use std::path::Path;

use devc::model::{Configuration, Device, Direction, Pdo, Role};
use devc::source::Disk;
use serde_json::json;

use super::{NINE, network, workspace};

/// The nine in the order of the cable.
fn devices() -> Vec<Device> {
    let families = ["c887", "s700", "pmc-sc6"].map(|name| {
        let folder = workspace().join(Path::new("devices")).join(name);
        devc::compile(&Disk, &folder).family.expect("the description has no errors")
    });
    families.iter().flat_map(|family| family.members.iter().cloned()).collect()
}

/// How many bytes a direction has by the PDOs of the description, as a configuration chooses or maps them.
fn bytes(device: &Device, chosen: Option<&Configuration>, way: Direction) -> u32 {
    let default = || device.assigned(Role::of(way)).map(|pdo| pdo.index).collect::<Vec<_>>();
    let pdos = chosen.and_then(|it| it.assigned(way)).map_or_else(default, <[_]>::to_vec);
    let is_written =
        |index| chosen.is_some_and(|it| it.startup.iter().any(|write| write.address.index == index));
    let own = |index| chosen?.mapping.iter().find(|pdo: &&Pdo| pdo.index == index && is_written(index));
    let pdos =
        pdos.iter().map(|index| own(*index).or_else(|| device.pdo(*index)).expect("there is such a PDO"));
    pdos.flat_map(|pdo| &pdo.entries).map(|entry| entry.bits).sum::<u32>().div_ceil(8)
}

#[test]
fn every_configuration_is_as_long_as_it_says() {
    let Some(mut network) = network("configured") else { return };
    network.run(&NINE);
    let devices = devices();
    let most = devices.iter().map(|device| device.configurations.len()).max().expect("nine");
    assert!(most >= 3, "there are devices with several");
    // a device that has fewer keeps its last one
    let chosen = |device: &'_ Device, round: usize| {
        let last = device.configurations.len().checked_sub(1)?;
        Some(device.configurations[round.min(last)].clone())
    };
    let rounds = (0..most).map(|round| {
        let lists = devices.iter().map(|device| {
            let writes = chosen(device, round).map(|it| it.startup).unwrap_or_default();
            let hex = |data: &[u8]| data.iter().map(|byte| format!("{byte:02x}")).collect::<String>();
            let writes =
                writes.iter().map(|it| json!([it.address.index.0, it.address.subindex, hex(&it.data)]));
            writes.collect::<Vec<_>>()
        });
        lists.collect::<Vec<_>>()
    });
    let told = network.ask("configure.py", &json!(rounds.collect::<Vec<_>>()));
    for (round, told) in told.iter().enumerate() {
        let lengths = devices.iter().map(|device| {
            let chosen = chosen(device, round);
            [Direction::Rx, Direction::Tx].map(|way| bytes(device, chosen.as_ref(), way))
        });
        assert_eq!(told["lengths"], json!(lengths.collect::<Vec<_>>()), "round {round}");
        assert_eq!((&told["states"], &told["wrong"]), (&json!(vec![8; 9]), &json!(0)), "round {round}");
    }
    assert_eq!(told.len(), most);
}
