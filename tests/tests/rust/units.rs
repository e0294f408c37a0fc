//! Units as types, by figures that the manuals print.

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::object::{Entry, ReadWrite};
use devc_runtime::pdo::Rx;
use devc_runtime::unit::{Angle, AngularVelocity, Current, Length, Motion, Unfit, Velocity};

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

/// C887T0011, p. 14: the SDOs 0x5000 to 0x5014 have lengths in micrometres and angles in thousandths of a degree,
/// and what is per time accordingly.
#[test]
fn entries_of_the_hexapod_are_in_their_own_units() {
    use c887::objects::{maximum_velocity_and_acceleration as maximum, work_coordinate_system as work};
    let origin = work::AXIS_X.exact(Length::millimetres(15));
    assert_eq!(origin.map(|value| work::AXIS_X.encode(value)), Ok(15_000_i32.to_le_bytes()));
    assert_eq!(work::AXIS_X.exact(Length::nanometres(1500)), Err(Unfit::Inexact));
    assert_eq!(work::AXIS_U.nearest(Angle::degrees(-2)), Ok(-2000));
    let upload = 20_000_i32.to_le_bytes();
    let fastest = maximum::TRANSLATIONAL_VELOCITY.decode(&upload);
    let fastest = fastest.map(|value| maximum::TRANSLATIONAL_VELOCITY.physical(value));
    assert_eq!(fastest, Ok(Velocity::millimetres_per_second(20)));
    assert_eq!(maximum::ROTATIONAL_VELOCITY.physical(250), AngularVelocity::millidegrees_per_second(250));
}

/// C887T0011, p. 14: X, Y and Z are positioned in millimetres, U, V and W in degrees, 100 000 steps each.
#[test]
fn what_an_axis_measures_is_asked_of_the_axis() {
    let steps = |axis| match c887::objects::target_position(axis).unit() {
        Motion::Linear(unit) => unit.exact::<i32>(Length::millimetres(1)),
        Motion::Rotary(unit) => unit.exact::<i32>(Angle::degrees(1)),
    };
    assert_eq!(c887::Axis::ALL.map(steps), [Ok(100_000); 6]);
    let at = |axis| c887::objects::position_actual_value(axis).physical(-150_000);
    let (line, turn) =
        (Motion::Linear(Length::micrometres(-1500)), Motion::Rotary(Angle::millidegrees(-1500)));
    assert_eq!(c887::Axis::ALL.map(at), [line, line, line, turn, turn, turn]);
}

/// S700, 3.7.1: speeds in process data have 139.81 counts to 1 rpm, the feed forward 128 times as many; 3280 counts are
/// the peak current of the amplifier, which only the drive knows; increments are counted as they are.
#[test]
fn entries_of_the_s700_say_what_their_numbers_mean() {
    use s700::{Family, s700::objects};
    assert_eq!(objects::VELOCITY_SETPOINT.nearest(AngularVelocity::rpm(100)), Ok(13_981));
    assert_eq!(objects::ADDITIVE_VELOCITY_SETPOINT.exact(AngularVelocity::rpm(1875)), Ok(128 * 262_144));
    assert_eq!(objects::CURRENT_SETPOINT.unit().raw(-1), Some(-3280));
    assert_eq!(objects::ACTUAL_CURRENT_VALUE.physical(1500), Current::milliamperes(1500));
    let _: Entry<Family, i32, ReadWrite, Rx> = objects::POSITION_SETPOINT;
}

/// Pilz 1005347, 5.1.4.2.2: 1 048 576 increments to a revolution, on either axis; a window has no sign.
#[test]
fn entries_of_the_pmc_turn() {
    use pmc_sc6::double::{Axis, objects};
    for axis in Axis::ALL {
        assert_eq!(objects::target_position(axis).exact(Angle::revolutions(-2)), Ok(-2_097_152));
        assert_eq!(objects::following_error_window(axis).exact(Angle::degrees(45)), Ok(131_072));
        assert_eq!(objects::following_error_window(axis).saturating(Angle::degrees(-1)), 0);
    }
}
