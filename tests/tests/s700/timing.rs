//! Cycles, jitter, scaling and other figures against chapters 2.1 and 3.6 to 3.11.

use std::collections::BTreeSet;

use devc::model::{Device, Parameter};
use devc_tests::manual::s700;

use crate::{MEMBERS, device, fact, family, holds_for, number, rows};

fn parameter(id: &str) -> &'static Parameter {
    let devices = family().members.iter();
    let mut parameters = devices.flat_map(|device| &device.parameters);
    parameters.find(|parameter| parameter.id == id).unwrap_or_else(|| panic!("there is no parameter {id}"))
}

fn limit(device: &'static Device, id: &str) -> &'static str {
    let found = device.limits.iter().find(|limit| limit.id == id);
    &found.unwrap_or_else(|| panic!("there is no limit {id}")).value
}

#[test]
fn cycle_times_are_those_of_each_member() {
    for member in MEMBERS {
        let printed: BTreeSet<_> = rows::<s700::CycleTime>()
            .into_iter()
            .filter(|row| row.members.contains(&member))
            .map(|row| (row.interface.to_lowercase(), Some(u64::from(row.min_us) * 1000)))
            .collect();
        let described: BTreeSet<_> = device(member)
            .cycle_times
            .iter()
            .map(|cycle| (cycle.id.clone(), cycle.min.map(|least| least.0)))
            .collect();
        assert_eq!(described, printed, "{member:?}");
        for setting in fact("cycle-advice").split(", ").map(|setting| setting.replace('=', " = ")) {
            let advises = |about: &String| about.contains(&setting);
            assert!(device(member).cycle_times.iter().all(|cycle| cycle.about.as_ref().is_some_and(advises)));
        }
    }
}

/// How the description writes a cycle.
fn written(us: u16) -> String {
    if us >= 1000 { format!("{} ms", us / 1000) } else { format!("{us} µs") }
}

#[test]
fn slow_cycles_are_those_of_each_member() {
    for member in MEMBERS {
        let mut parts = Vec::new();
        for row in rows::<s700::SlowCycle>().into_iter().filter(|row| holds_for(&row.members, member)) {
            let cycle = written(row.cycle_us);
            parts.push(match row.mappings[..] {
                [] => cycle,
                [one] => format!("{cycle} with mapping {one}"),
                [first, last] => format!("{cycle} with the mappings {first} and {last}"),
                [first, .., last] => format!("{cycle} with the mappings {first} to {last}"),
            });
        }
        let value = limit(device(member), "background-cycle");
        assert!(
            parts.iter().all(|part| value.contains(part.as_str())),
            "{member:?}: {value:?} lacks {parts:?}"
        );
    }
}

#[test]
fn figures_are_those_of_the_text() {
    let figures = [
        ("pll-deviation-ppm", "cycle-deviation", "ppm"),
        ("jitter-at-least-1-ms-us", "jitter", "µs"),
        ("jitter-up-to-750-us-us", "jitter-of-short-cycles", "µs"),
        ("max-speed-sinusoidal-rpm", "rotary-speed-sinusoidal", "rpm"),
        ("max-speed-trapezoidal-rpm", "rotary-speed-trapezoidal", "rpm"),
        ("max-speed-linear-sinusoidal-m-per-s", "linear-speed-sinusoidal", "m/s"),
        ("max-speed-linear-trapezoidal-m-per-s", "linear-speed-trapezoidal", "m/s"),
        ("extended-mapping-above-bytes", "fixed-mapping", "bytes"),
        ("free-max-bytes", "free-mapping", "bytes"),
    ];
    for member in MEMBERS {
        for (key, id, unit) in figures {
            // What concerns long mappings is left out where there are none.
            let missing = device(member).limits.iter().all(|limit| limit.id != id);
            if missing && unit == "bytes" {
                assert!(!fact("extended-mapping-members").contains(&device(member).name));
                continue;
            }
            assert_eq!(limit(device(member), id), format!("{} {unit}", fact(key)));
        }
    }
}

#[test]
fn scales_are_those_of_the_text() {
    let scale = |id: &str| {
        let unit = device(MEMBERS[0]).unit(id).and_then(|unit| unit.on(None));
        let scale = unit.and_then(|unit| unit.scale).unwrap_or_else(|| panic!("{id} has a scale"));
        f64::from(u32::try_from(scale.raw).expect("it is short"))
            / f64::from(u32::try_from(scale.units).expect("it is short"))
    };
    assert_eq!(format!("{:.2}", scale("velocity")), fact("velocity-counts-per-rpm"));
    assert_eq!(format!("{:.0}", scale("velocity-feed-forward")), fact("feed-forward-increments-per-rpm"));
    assert_eq!(format!("{:.0}", scale("peak-current")), fact("peak-current-increments"));
    let position = device(MEMBERS[0]).unit("position").and_then(|unit| unit.about.as_deref());
    assert!(position.is_some_and(|about| about.contains(fact("position-increments-per-revolution"))));
}

#[test]
fn bits_of_parameters_are_those_of_the_text() {
    let has = |parameter: &Parameter, value: i64| parameter.values.iter().any(|it| it.first == value);
    assert!(has(parameter(fact("extended-mapping-parameter")), number("extended-mapping-value").into()));
    assert_eq!(1 << number("free-mapping-bit"), number("extended-mapping-value"));
    assert_eq!(fact("clear-fault-parameter"), "SERCSET bit 19");
    assert_eq!(fact("sync-monitoring-off"), "SERCSET bits 17 and 18");
    assert!([17, 18, 19].into_iter().all(|bit| has(parameter("SERCSET"), 1 << bit)));
    assert_eq!(fact("feed-forward-parameter"), "FFTSW bit 0x20");
    assert!(has(parameter("FFTSW"), 0x20));
    let cycle = parameter(fact("cycle-parameter"));
    assert_eq!(cycle.symbol, Some(format!("{} µs", fact("cycle-increment-us"))));
    let example = format!("{} stands for {} ms", fact("cycle-example-ptbase"), fact("cycle-example-ms"));
    assert!(cycle.about.as_ref().is_some_and(|about| about.contains(&example)));
}

#[test]
fn numbers_of_faults_are_those_of_the_text() {
    for key in ["loss-of-sync-warning", "sync-fault", "hardware-reset-fault"] {
        let code: u32 = fact(key)[1..].parse().expect("a letter and a number");
        let known = device(MEMBERS[0]).vendor_codes.iter().find(|it| it.code == code);
        assert!(known.is_some_and(|it| it.name.starts_with(fact(key))), "{key}");
    }
}
