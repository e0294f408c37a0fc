//! What is said of images that a device does not take, by the objects of ETG.1000.6 for the assignment of PDOs.

use super::{Carrier, MappedPdo, SyncManager};
use crate::text::Text;

fn pdos<const N: usize>(indices: [u16; N]) -> [MappedPdo; N] {
    indices.map(|index| MappedPdo::new(index, &[]))
}

/// Two sync managers a direction, as a device with a safe channel has them.
const CARRIERS: &[Carrier<'static>] = &[
    Carrier { assignment: 0x1C12, pdos: &[0x1600, 0x1601] },
    Carrier { assignment: 0x1C14, pdos: &[0x1610] },
];

const ANY: SyncManager = SyncManager {
    carriers: CARRIERS,
    assignable: true,
    slots: 3,
    max_size: Some(8),
    mandatory: &[0x1600],
    exclusive: &[[0x1601, 0x1602]],
};
const FIXED: SyncManager = SyncManager { assignable: false, ..ANY };

#[track_caller]
fn said(manager: &SyncManager, indices: &[u16], bytes: usize, expected: Option<&str>) {
    let mut all = [MappedPdo::new(0, &[]); 4];
    let all = &mut all[..indices.len()];
    all.iter_mut().zip(indices).for_each(|(pdo, index)| *pdo = MappedPdo::new(*index, &[]));
    let fault = manager.image_fault(all, bytes);
    assert_eq!(fault.as_ref().map(Text::as_str), expected, "{indices:04X?}");
}

#[test]
fn an_image_has_as_many_pdos_and_bytes_as_the_device_takes() {
    said(&ANY, &[0x1600, 0x1601, 0x1603], 8, None);
    said(&ANY, &[0x1600, 0x1601, 0x1603, 0x1604], 8, Some("4 PDOs are in the image, the device takes 3"));
    said(&ANY, &[0x1600], 9, Some("the image has 9 bytes, the device takes 8"));
    said(&SyncManager { max_size: None, ..ANY }, &[0x1600], 900, None);
    said(&ANY, &[0x1601], 2, Some("0x1600 is missing, the device does not do without it"));
    said(&ANY, &[0x1601, 0x1600], 2, None);
}

#[test]
fn what_cannot_be_assigned_is_as_it_is() {
    let other = Some("the device does not let its assignment be changed: it is 0x1600, 0x1601, 0x1610");
    said(&FIXED, &[0x1600, 0x1601, 0x1610], 8, None);
    for indices in [
        &[0x1600, 0x1601][..],
        &[0x1600, 0x1610],
        &[0x1601, 0x1600, 0x1610],
        &[0x1600, 0x1601, 0x1610, 0x1611],
        &[],
    ] {
        said(&FIXED, indices, 8, other);
    }
}

#[test]
fn two_pdos_that_exclude_each_other_do_not_go_together() {
    let said = |others: &[MappedPdo], pdo: u16, expected: Option<&str>| {
        assert_eq!(ANY.pair_fault(others, pdo).as_ref().map(Text::as_str), expected);
    };
    let behind = pdos([0x1600, 0x1601]);
    said(&behind, 0x1602, Some("0x1601 and 0x1602 cannot be assigned together"));
    said(&pdos([0x1602]), 0x1601, Some("0x1602 and 0x1601 cannot be assigned together"));
    said(&behind, 0x1600, Some("0x1600 is in the image twice"));
    said(&behind, 0x1603, None);
    said(&[], 0x1602, None);
    assert!(ANY.excludes(0x1601, 0x1602) && ANY.excludes(0x1602, 0x1601));
    assert!(!ANY.excludes(0x1601, 0x1601) && !ANY.excludes(0x1602, 0x1602) && !ANY.excludes(0x1600, 0x1602));
}

#[test]
fn what_has_to_be_there_is_that_of_the_sync_manager() {
    let manager = SyncManager { mandatory: &[0x1600, 0x1610, 0x1611], ..ANY };
    assert_eq!((manager.mandatory_of(0x1C12), manager.mandatory_of(0x1C14)), (1, 1));
    assert_eq!(manager.mandatory_of(0x1C13), 0);
    let only = SyncManager { carriers: CARRIERS.split_at(1).0, ..manager };
    assert_eq!(only.mandatory_of(0x1C12), 3, "there is nothing else that could carry them");
}
