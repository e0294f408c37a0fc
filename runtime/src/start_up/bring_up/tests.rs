//! Which devices of a family one start-up list is right for.

use super::{AxisObjects, are_alike, is_same};

const fn axis(mode: Option<u16>, cycle: Option<u16>) -> AxisObjects {
    AxisObjects { mode, cycle }
}

#[test]
fn devices_are_alike_if_each_axis_has_the_same_objects() {
    let first = axis(Some(0x6060), Some(0x60C2));
    let second = axis(Some(0x6860), Some(0x68C2));
    let alike: [(&[AxisObjects], &[AxisObjects]); 3] =
        [(&[], &[]), (&[first], &[first]), (&[first, second], &[first, second])];
    for (one, other) in alike {
        assert!(are_alike(one, other));
    }
    let without =
        [axis(None, Some(0x60C2)), axis(Some(0x6060), None), axis(Some(0x6061), Some(0x60C2)), second];
    for other in without {
        assert!(!are_alike(&[first], &[other]) && !are_alike(&[other], &[first]));
        assert!(!are_alike(&[first, first], &[first, other]), "on the second axis");
    }
    assert!(!are_alike(&[first], &[first, second]) && !are_alike(&[first, second], &[first]));
    assert!(is_same(None, None) && is_same(Some(1), Some(1)));
    assert!(!is_same(None, Some(1)) && !is_same(Some(1), None) && !is_same(Some(1), Some(2)));
}
