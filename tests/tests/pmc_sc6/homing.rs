//! Homing methods against table 4 and the chapter of each.

use std::collections::BTreeSet;

use devc::model::{HomingMethod, Way};
use devc_tests::manual::pmc_sc6;

use crate::{departs, device, plain, rows};

fn method(letter: &str) -> &'static HomingMethod {
    let found = device().homing_methods.iter().find(|it| it.method.as_deref() == Some(letter));
    found.unwrap_or_else(|| panic!("there is no method {letter}"))
}

#[test]
fn methods_are_19_with_20_codes() {
    assert_eq!(device().homing_methods.len(), 19);
    let mut all = BTreeSet::new();
    for row in rows::<pmc_sc6::Homing>() {
        let method = method(row.method);
        let codes: Vec<i8> = std::iter::once(method.number).chain(method.aliases.iter().copied()).collect();
        assert_eq!(codes, row.codes, "method {}", row.method);
        all.extend(codes);
    }
    assert_eq!(all.len(), 20);
    let listed = device().object(devc::model::Index(0x60E3)).map(|object| object.highest_subindex());
    assert_eq!(listed, Some(20));
}

#[test]
fn methods_look_for_what_the_table_says() {
    for row in rows::<pmc_sc6::Homing>() {
        let method = method(row.method);
        assert_eq!(method.name, row.name);
        let way = match row.direction {
            "Positive" => Some(Way::Positive),
            "Negative" => Some(Way::Negative),
            _ => None,
        };
        assert_eq!(method.direction, way, "method {}", row.method);
        assert_eq!(method.pulse, row.zero_pulse, "method {}", row.method);
        let target = method.target.as_deref().map(plain).unwrap_or_default();
        assert_eq!(target, plain(row.feature), "method {}", row.method);
    }
}

#[test]
fn methods_start_where_their_chapters_say() {
    for row in rows::<pmc_sc6::Homing>() {
        let method = method(row.method);
        let variants = if method.alternatives.is_empty() { 1 } else { method.alternatives.len() };
        assert_eq!(variants, usize::from(row.variants), "method {}", row.method);
        assert_eq!(method.steps.is_empty(), variants > 1, "method {}", row.method);
    }
}

#[test]
fn methods_are_prepared_as_their_chapters_say() {
    let mut other = BTreeSet::new();
    for row in rows::<pmc_sc6::Homing>() {
        let described: BTreeSet<&str> = method(row.method).parameters.iter().map(String::as_str).collect();
        let printed: BTreeSet<&str> = row.prepared.iter().copied().collect();
        for parameter in described.symmetric_difference(&printed) {
            // What the steps, not the preparation, make of I43.
            if *parameter != "I43" {
                other.insert((row.method, *parameter));
            }
        }
        let used = |steps: &[String]| steps.iter().any(|step| step.contains("I43"));
        let method = method(row.method);
        let moves = used(&method.steps) || method.alternatives.iter().any(|it| used(&it.steps));
        assert_eq!(described.contains("I43"), moves, "method {}", row.method);
    }
    departs(other, []);
}
