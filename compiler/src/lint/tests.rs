//! The order of the rules does not show.

use std::path::Path;

use super::{ALL, Lint, run};
use crate::compile::{Compilation, resolved};
use crate::diagnostic::Diagnostics;
use crate::source::Disk;

/// A description with many findings: the C-887 without its errata.
fn findings<'l>(rules: impl Iterator<Item = &'l Lint> + Clone) -> Diagnostics {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices/c887");
    let mut compilation = Compilation::default();
    let resolved = resolved(&Disk, &path, &mut compilation, &mut |_| ());
    let (mut resolved, levels) = resolved.expect("the description resolves");
    resolved.held = None;
    for device in &mut resolved.printed.members {
        device.errata.clear();
    }
    run(rules, &resolved, &levels, &compilation.sources, &mut compilation.diagnostics);
    compilation.diagnostics.finish();
    compilation.diagnostics
}

#[test]
fn rules_may_run_in_any_order() {
    let expected = findings(ALL.iter());
    assert!(expected.iter().count() > 20, "the manual of the C-887 has many faults");
    let mut rules: Vec<&Lint> = ALL.iter().collect();
    let mut seed = 1_usize;
    for _ in 0..20 {
        for place in (1..rules.len()).rev() {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            rules.swap(place, (seed >> 33) % (place + 1));
        }
        let names: Vec<_> = rules.iter().map(|lint| lint.rule.name).collect();
        assert!(findings(rules.iter().copied()) == expected, "the order {names:?} shows");
    }
}
