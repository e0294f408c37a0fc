//! Units as types, by figures that the manuals print.

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::unit::{Angle, AngularVelocity, Length, Unfit, Velocity};

/// C887T0011, p. 14: in process data 100 000 steps are a millimetre or a degree; in SDOs, steps are micrometres and
/// thousandths of a degree.
#[test]
fn a_length_has_the_number_of_the_way_it_goes() {
    let length = Length::millimetres(15);
    assert_eq!(c887::units::POSITION_MM.exact::<i32>(length), Ok(1_500_000));
    assert_eq!(c887::units::SDO_LENGTH.exact::<i32>(length), Ok(15_000));

    let angle = Angle::degrees(-2);
    assert_eq!(c887::units::POSITION_DEG.exact::<i32>(angle), Ok(-200_000));
    assert_eq!(c887::units::SDO_ANGLE.exact::<i32>(angle), Ok(-2000));
    assert_eq!(c887::units::VELOCITY_MM_PER_S.physical(100_000_i32), Velocity::millimetres_per_second(1));
}

/// S700, 3.7.1: 139.81 counts are 1 rpm in 0x60FF of fixed mappings; which is 2^18 ÷ 1875.
#[test]
fn a_velocity_is_rounded_only_on_request() {
    let unit = s700::s700::units::VELOCITY;
    assert_eq!(unit.exact::<i32>(AngularVelocity::rpm(1875)), Ok(262_144));
    assert_eq!(unit.exact::<i32>(AngularVelocity::rpm(100)), Err(Unfit::Inexact));
    assert_eq!(unit.nearest::<i32>(AngularVelocity::rpm(100)), Ok(13_981));
    assert_eq!(unit.physical(262_144_i32), AngularVelocity::rpm(1875));
}

/// Pilz 1005347, 5.1.4.2.2: 1 048 576 increments are a revolution of the encoder.
#[test]
fn a_revolution_is_360_degrees() {
    let unit = pmc_sc6::double::units::POSITION;
    assert_eq!(unit.exact::<i32>(Angle::revolutions(1)), Ok(1_048_576));
    assert_eq!(unit.physical(-1_048_576_i32).in_degrees(), -360.0);
}

#[test]
fn nothing_wraps() {
    let unit = c887::units::POSITION_MM;
    for far in [Length::metres(i64::MAX), Length::metres(22), Length::micrometres(21_474_836_480)] {
        assert_eq!(unit.exact::<i32>(far), Err(Unfit::OutOfRange), "{far}");
        assert_eq!(unit.nearest::<i32>(far), Err(Unfit::OutOfRange), "{far}");
        assert_eq!(unit.saturating::<i32>(far), i32::MAX, "{far}");
    }
    assert_eq!(unit.saturating::<i32>(Length::metres(i64::MIN)), i32::MIN);
    assert_eq!(unit.saturating::<u16>(Length::millimetres(-1)), 0);
}
