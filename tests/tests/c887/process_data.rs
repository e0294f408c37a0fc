//! PDOs and their assignment against the appendix.

use std::collections::BTreeSet;

use devc::model::{Direction, Index, Role};
use devc_tests::manual::{self, c887};

use crate::{device, rows};

#[test]
fn mapped_entries_are_those_of_the_manual() {
    let rows = rows::<c887::Mapped>();
    assert_eq!(rows.len(), 90);
    let printed: BTreeSet<_> = rows
        .iter()
        .map(|row| (row.pdo, row.position, row.index, row.subindex, u32::from(row.bits), row.name))
        .collect();
    let pdos = &device().pdos;
    assert_eq!(pdos.len(), 24);
    let described: BTreeSet<_> = pdos
        .iter()
        .flat_map(|pdo| {
            (1_u8..).zip(&pdo.entries).map(|(position, entry)| {
                let address = entry.address.expect("nothing is padded");
                let name = entry.name.as_str();
                (pdo.index.0, position, address.index.0, address.subindex, entry.bits, name)
            })
        })
        .collect();
    assert_eq!(described, printed);
}

#[test]
fn directions_are_those_of_the_manual() {
    for row in rows::<c887::Mapped>() {
        let direction = match row.direction {
            manual::Direction::Rx => Direction::Rx,
            manual::Direction::Tx => Direction::Tx,
        };
        assert_eq!(device().pdo(Index(row.pdo)).map(|pdo| pdo.direction), Some(direction));
    }
}

#[test]
fn the_default_assignment_is_that_of_the_manual() {
    for (role, object) in [(Role::Outputs, 0x1C12), (Role::Inputs, 0x1C13)] {
        let rows: Vec<_> = rows::<c887::Assigned>().into_iter().filter(|row| row.object == object).collect();
        let printed: Vec<u16> = rows.iter().filter_map(|row| row.pdo).collect();
        let manager = device().sync_manager(role).expect("there is a sync manager");
        let described: Vec<u16> = manager.pdos.iter().map(|pdo| pdo.0).collect();
        assert_eq!(described, printed);
        assert_eq!(usize::from(manager.slots), rows.len());
    }
}

#[test]
fn the_startup_list_assigns_what_the_manual_assigns() {
    let csp = device().configurations.iter().find(|it| it.id == "csp").expect("it is described");
    for object in [0x1C12, 0x1C13] {
        let rows: Vec<_> = rows::<c887::Assigned>().into_iter().filter(|row| row.object == object).collect();
        let mut printed = vec![(0, vec![0])];
        let pdos = (1..).zip(rows.iter().filter_map(|row| row.pdo));
        printed.extend(pdos.map(|(place, pdo)| (place, pdo.to_le_bytes().to_vec())));
        printed.push((0, vec![6]));
        let writes = csp.startup.iter().filter(|write| write.address.index.0 == object);
        let written: Vec<_> = writes.map(|write| (write.address.subindex, write.data.clone())).collect();
        assert_eq!(written, printed);
    }
}

#[test]
fn images_have_their_sizes() {
    assert_eq!(device().image_bytes(Role::Outputs), 42);
    assert_eq!(device().image_bytes(Role::Inputs), 66);
}
