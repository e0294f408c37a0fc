//! Causes of events and denials, and the values of the PDO timeout, against chapters 5.1 and 6.3.

use devc::model::{Parameter, VendorCode};
use devc_tests::manual::pmc_sc6;

use crate::{departs, device, fact, plain, rows};

fn event(code: u32) -> &'static VendorCode {
    let found = device().vendor_codes.iter().find(|event| event.code == code);
    found.unwrap_or_else(|| panic!("there is no event {code}"))
}

fn parameter(id: &str) -> &'static Parameter {
    let found = device().parameters.iter().find(|parameter| parameter.id == id);
    found.unwrap_or_else(|| panic!("there is no parameter {id}"))
}

/// The values and names that the description has at a place of the table.
fn described(place: &str) -> Vec<(i64, &'static str)> {
    if let Some(number) = place.strip_prefix("event ") {
        let causes = &event(number.parse().expect("a number")).causes;
        return causes.iter().map(|cause| (cause.value, cause.name.as_str())).collect();
    }
    parameter(place).values.iter().map(|value| (value.first, value.name.as_str())).collect()
}

/// The manual's abbreviations written out.
fn written_out(name: &str) -> String {
    let name = plain(name).replace("swlimit", "softwarelimit").replace("hwlimit", "hardwarelimit");
    let ends = ["positive", "negative"].into_iter().find_map(|end| Some((end, name.strip_suffix(end)?)));
    ends.map_or(name.clone(), |(end, rest)| format!("{end}{rest}"))
}

#[test]
fn causes_are_those_of_the_manual() {
    let rows = rows::<pmc_sc6::Cause>();
    for row in &rows {
        let printed: Vec<i64> =
            rows.iter().filter(|other| other.place == row.place).map(|other| other.code.into()).collect();
        assert_eq!(
            described(row.place).iter().map(|(code, _)| *code).collect::<Vec<_>>(),
            printed,
            "{}",
            row.place
        );
    }
    let other = rows.iter().filter(|row| {
        let found = described(row.place).into_iter().find(|(code, _)| *code == i64::from(row.code));
        found.map(|(_, name)| plain(name)) != Some(written_out(row.name))
    });
    let known = [
        (("event 53", 5), "without the word reached"),
        (("event 78", 3), "max. written out"),
        (("I90", 10), "without the word denied"),
    ];
    departs(other.map(|row| (row.place, row.code)), known);
}

#[test]
fn limits_of_software_switches_are_those_of_the_text() {
    assert_eq!((fact("limit-switch-event"), fact("extrapolation-event")), ("53", "78"));
    // The conditions are prose; that the window counts, and which, is said.
    let about = event(53).about.as_deref().unwrap_or_default();
    assert!(about.contains(fact("limit-window")), "{about}");
    let slips = rows::<pmc_sc6::LimitCondition>().into_iter().filter(|row| {
        // A fault comes beyond the limit, a lock goes within it.
        let beyond = if row.switch == "positive" { (">", "+") } else { ("<", "-") };
        let within = if row.switch == "positive" { ("<", "-") } else { (">", "+") };
        (row.relation, row.window) != if row.effect == "fault" { beyond } else { within }
    });
    let why = "the fault would come within the limit; symmetry and the lock have the other sign";
    let known = [(("6.3.1.1", "negative"), why), (("6.3.1.7", "negative"), why)];
    departs(slips.map(|row| (row.section, row.switch)), known);
    let remarked = |text: &str| text.contains("limit - I22");
    assert!(
        device()
            .remarks
            .iter()
            .any(|remark| remark.at.to_string() == "vendor-codes.53" && remarked(&remark.text))
    );
}

#[test]
fn timeouts_are_those_of_the_list() {
    let timeout = parameter("A258");
    let printed: Vec<_> = rows::<pmc_sc6::PdoTimeout>()
        .iter()
        .map(|row| (i64::from(row.first), i64::from(row.last), row.monitoring))
        .collect();
    let values = timeout.values.iter();
    let described: Vec<_> =
        values.map(|value| (value.first, value.last, !value.name.starts_with("not"))).collect();
    assert_eq!(described, printed);
    let max = timeout.max.as_ref().map(ToString::to_string);
    assert_eq!(max.as_deref(), Some(fact("pdo-timeout-max")));
}
