//! Units that differ from axis to axis, through the derive.

use devc_runtime::Device;
use devc_runtime::object::{Entry, ReadOnly, ReadWrite};
use devc_runtime::pdo::Unmapped;
use devc_runtime::unit::{Angle, AngularVelocity, Force, Length, Motion, Scale, Torque, Unfit};

#[expect(unreachable_pub, reason = "a device is public, a test is not")]
#[derive(Device)]
#[device(path = "tests/rust/geared")]
pub struct Geared;

use geared::{Axis, objects};

/// A and B turn, 1000 and 50 steps to a degree; C moves along a line, 10 steps to a millimetre.
#[test]
fn the_unit_is_that_of_the_axis() {
    let ten = |axis| match objects::position_actual_value(axis).unit() {
        Motion::Rotary(unit) => unit.exact(Angle::degrees(10)),
        Motion::Linear(unit) => unit.exact(Length::millimetres(10)),
    };
    assert_eq!(Axis::ALL.map(ten), [Ok(10_000), Ok(500), Ok(100_i32)]);
    let shown = Axis::ALL.map(|axis| objects::position_actual_value(axis).physical(-100).to_string());
    assert_eq!(shown, ["-0.1 °", "-2 °", "-0.01 m"]);
}

/// Where all axes measure the same there is nothing to match, though B has a gear of its own.
#[test]
fn a_scale_alone_needs_no_match() {
    let speed = AngularVelocity::rpm(3);
    let raw = Axis::ALL.map(|axis| objects::max_profile_velocity(axis).exact(speed));
    assert_eq!(raw, [Ok(30), Ok(600), Ok(30_u32)]);
    let back = AngularVelocity::rpm(-3);
    assert_eq!(objects::max_profile_velocity(Axis::A).exact(back), Err(Unfit::OutOfRange));
    assert_eq!(objects::max_profile_velocity(Axis::A).saturating(back), 0);
}

#[test]
fn a_force_is_the_torque_of_a_linear_axis() {
    let load = Axis::ALL.map(|axis| objects::target_torque(axis).physical(25));
    let turning = Motion::Rotary(Torque::millinewton_metres(25));
    assert_eq!(load, [turning, turning, Motion::Linear(Force::millinewtons(2500))]);
}

/// The types are the test: what no unit of the runtime can say is an entry without one.
#[test]
fn an_entry_has_no_unit_where_none_is_right() {
    use objects::limits_of_the_controller as limits;
    let current: Entry<Geared, u16, ReadWrite, Unmapped, Scale> = limits::CURRENT;
    assert_eq!(current.unit().raw(2), Some(2 * 3280));
    // no whole number
    let _: Entry<Geared, f32, ReadOnly> = limits::TEMPERATURE;
    // of the device, and the unit depends on the axis
    let _: Entry<Geared, i32, ReadWrite> = limits::POSITION;
    // increments on two axes, millimetres on the third
    let _: Entry<Geared, u32, ReadWrite> = objects::position_window(Axis::C);
}
