//! Times, touch probes, start-up lists and other figures of the manual.

use std::collections::BTreeSet;

use devc::model::{Device, SyncMode, Value};
use devc_tests::manual::pmc_sc6;

use crate::{device, fact, family, rows};

#[test]
fn cycle_times_are_those_of_table_29() {
    for signal in ["Application", "Digital inputs"] {
        let rows = rows::<pmc_sc6::CycleTime>().into_iter().filter(|row| row.signal == signal);
        let printed: Vec<_> = rows.map(|row| u64::from(row.cycle_us) * 1000).collect();
        let described = device().cycle_times.iter().find(|cycle| cycle.name == signal);
        let choices = described.map(|cycle| cycle.choices.iter().map(|choice| choice.0).collect());
        assert_eq!(choices, Some(printed), "{signal}");
        let parameter = fact("application-cycle");
        let about = described.and_then(|cycle| cycle.about.as_deref()).unwrap_or_default();
        assert!(about.contains(parameter), "{about}");
    }
    let timestamp = format!("{} µs", fact("touch-probe-timestamp-us"));
    assert!(
        device()
            .cycle_times
            .iter()
            .any(|it| it.about.as_ref().is_some_and(|about| about.contains(&timestamp)))
    );
}

#[test]
fn start_up_lists_write_in_the_transitions_of_the_text() {
    let assumed = |id: &str| {
        let at = format!("communication-transitions.{id}");
        device().assumptions.iter().any(|assumption| assumption.at.to_string() == at)
    };
    let stated = device().communication_transitions.iter().filter(|transition| !assumed(&transition.id));
    let described: BTreeSet<_> = stated.map(|transition| transition.id.as_str()).collect();
    let printed = rows::<pmc_sc6::StartupTransition>().iter().map(|row| row.transition).collect();
    assert_eq!(described, printed);
}

#[test]
fn touch_probes_have_the_bits_of_the_text() {
    for (parameter, id) in [("A594", "touch-probe-function"), ("A595", "touch-probe-status")] {
        let word = device().word(id).expect("it is described");
        let object = device().object(word.address.index).expect("it is in the dictionary");
        assert_eq!(object.parameter.as_deref(), Some(parameter));
        for row in rows::<pmc_sc6::TouchProbeBit>().into_iter().filter(|row| row.parameter == parameter) {
            // Bits 8 to 15 are the same for the second measurement.
            for bit in [row.bit, row.bit + 8] {
                let field = word.fields.iter().find(|field| (field.low..=field.high).contains(&bit));
                assert!(field.is_some_and(|field| !field.reserved), "{parameter}, bit {bit}");
            }
        }
    }
}

#[test]
fn areas_and_shifts_are_those_of_the_text() {
    let area = |first: u16, last: u16| format!("0x{first:04X} to 0x{last:04X}");
    let keys = [
        ("profile-area-a", "profile-area-b", "axis-shift-profile"),
        ("manufacturer-area-a", "manufacturer-area-b", "axis-shift-manufacturer"),
    ];
    for (a, b, by) in keys {
        let shift = device().arrangement.shifts.iter().find(|it| area(it.first.0, it.last.0) == fact(a));
        let shift = shift.unwrap_or_else(|| panic!("nothing shifts {}", fact(a)));
        assert_eq!(area(shift.first.0 + shift.by, shift.last.0 + shift.by), fact(b));
        assert_eq!(format!("0x{:X}", shift.by), fact(by));
    }
}

fn sync_mode(name: &str) -> &'static SyncMode {
    let found = device().sync_modes.iter().find(|mode| mode.name == name);
    found.unwrap_or_else(|| panic!("there is no synchronisation {name}"))
}

#[test]
fn synchronisation_is_that_of_the_text() {
    let clocks = sync_mode(fact("sync-mode-dc"));
    assert_eq!((clocks.default, clocks.sync0.is_some(), clocks.sync1.is_some()), (true, true, false));
    let managers = sync_mode(fact("sync-mode-sm"));
    assert_eq!((managers.default, managers.sync0.is_some()), (false, false));
}

/// The default of a parameter.
fn preset<'a>(device: &'a Device, id: &str) -> Option<&'a Value> {
    device.parameters.iter().find(|parameter| parameter.id == id)?.default.as_ref()
}

#[test]
fn presets_are_those_of_the_text() {
    let number = |key: &str| fact(key).parse().ok().map(Value::Integer);
    assert_eq!(preset(device(), "A213"), number("fieldbus-scaling-default").as_ref());
    assert_eq!(preset(device(), "A166"), number("dhcp-default").as_ref());
    for device in &family().members {
        let feed = device.object(devc::model::Index(0x6092)).expect("it is in the tables");
        let of = |subindex| feed.entry(subindex).and_then(|entry| entry.default.clone());
        // Units of the user have no preset in HiRes Motion.
        let stated = !device.id.ends_with("hires");
        assert_eq!(of(1), number("feed-constant-default").filter(|_| stated), "{}", device.id);
        assert_eq!(of(2), number("shaft-revolutions-default").filter(|_| stated), "{}", device.id);
    }
    let bits: u32 = fact("feed-constant-default-bits").parse().expect("a number");
    assert_eq!(fact("feed-constant-default"), (1_u32 << bits).to_string());
}

#[test]
fn the_scale_of_positions_is_that_of_the_text() {
    let scale = device().unit("position").and_then(|unit| unit.on(None)).and_then(|unit| unit.scale);
    let scale = scale.expect("increments have a scale");
    // 360/1048576 in lowest terms.
    assert_eq!((scale.raw * 360, fact("scaling-formula")), (scale.units * 1_048_576, "360/1048576"));
}

#[test]
fn levels_of_access_are_those_of_the_text() {
    let level = device().parameters.iter().find(|parameter| parameter.id == "A10").expect("it is described");
    assert_eq!(level.values.len().to_string(), fact("access-levels"));
    assert!(level.about.as_ref().is_some_and(|about| about.contains(fact("access-level-fieldbus"))));
}

#[test]
fn the_mailbox_carries_what_the_text_names() {
    for device in &family().members {
        let mailbox = device.mailbox.as_ref().expect("there is one");
        assert_eq!(mailbox.protocols.iter().any(|it| it.name() == "EoE"), fact("eoe") == "yes");
    }
    for key in ["drive-software", "firmware"] {
        assert!(device().about.as_ref().is_some_and(|about| about.contains(fact(key))), "{key}");
    }
}
