//! Configurations of `ethercat_driver_ros2`, read by the library that it uses (yaml-cpp) with the types that it asks for.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use devc::emit::icube::Icube;
use serde_json::Value as Json;

use crate::expected::bytes;
use crate::model::{list, number, text, word};
use crate::tools::{run, tool};
use crate::ways::{each_file, step};

/// The reader, compiled; none where there is no compiler or no library.
fn reader(folder: &Path) -> Option<()> {
    let compiler = tool(&["g++", "c++"])?;
    std::fs::write(folder.join("icube.cpp"), include_str!("icube.cpp")).unwrap();
    let header =
        ["-std=c++17", "-E", "-include", "yaml-cpp/yaml.h", "-x", "c++", "/dev/null", "-o", "/dev/null"];
    if !Command::new(compiler).args(header).output().is_ok_and(|it| it.status.success()) {
        eprintln!("skipped, since there is no yaml-cpp");
        return None;
    }
    run(folder, compiler, &["-std=c++17", "-o", "reader", "icube.cpp", "-lyaml-cpp"]);
    Some(())
}

#[test]
fn configurations_are_what_the_model_says() {
    let folder = tempfile::tempdir().unwrap();
    let Some(()) = reader(folder.path()) else { return };
    each_file(&Icube, |file, content, member, configuration| {
        std::fs::write(folder.path().join("slave.yaml"), content).unwrap();
        let output = run(folder.path(), "./reader", &["slave.yaml"]);
        let found = String::from_utf8(output.stdout).unwrap();
        compare(file, &found, &expected(member, configuration));
    });
}

/// Line by line and word by word, numbers with a fraction as numbers.
fn compare(file: &str, found: &str, expected: &[String]) {
    let found: Vec<&str> = found.lines().collect();
    for (found, expected) in found.iter().zip(expected) {
        let same = |(one, two): (&str, &str)| match (one.parse::<f64>(), two.parse::<f64>()) {
            (Ok(one), Ok(two)) => (one - two).abs() <= two.abs() * 1e-12 || one.is_nan() && two.is_nan(),
            _ => one == two,
        };
        let (mut one, mut two) = (found.split(' '), expected.split(' '));
        let equal = one.by_ref().zip(two.by_ref()).all(same) && one.next().is_none() && two.next().is_none();
        assert!(equal, "{file}\n found    {found}\n expected {expected}");
    }
    assert_eq!(found.len(), expected.len(), "lines of {file}");
}

fn expected(member: &Json, configuration: Option<&Json>) -> Vec<String> {
    let identity = &member["identity"];
    let mut lines =
        vec![format!("identity {} {}", number(identity, "vendor_id"), number(identity, "product_code"))];
    let synchronous = list(member, "sync_modes").iter().any(|mode| mode["assign_activate"] != 0);
    let clocks = if synchronous { number(&list(member, "sync_modes")[0], "assign_activate") } else { 0 };
    lines.push(format!("clocks {clocks}"));
    for write in configuration.into_iter().flat_map(|it| list(it, "startup")) {
        let (index, data) = (number(&write["address"], "index"), bytes(&write["data"]));
        let assigns = matches!(index, 0x1C12 | 0x1C13 | 0x1600..=0x17FF | 0x1A00..=0x1BFF);
        if assigns || !["IP", "PS"].contains(&text(write, "transition")) || ![1, 2, 4].contains(&data.len()) {
            continue;
        }
        let negative = data[data.len() - 1] & 0x80 != 0;
        let filled: Vec<u8> =
            data.iter().copied().chain([if negative { 0xFF } else { 0 }; 4]).take(4).collect();
        let value = i32::from_le_bytes(filled.try_into().unwrap());
        let subindex = number(&write["address"], "subindex");
        lines.push(format!("sdo {index} {subindex} {} {value}", data.len() * 8));
    }
    for (way, role) in [("rpdo", "outputs"), ("tpdo", "inputs")] {
        let mut taken = BTreeMap::new();
        for index in assigned(member, configuration, role) {
            lines.push(format!("{way} {index}"));
            let mapped = configuration.into_iter().flat_map(|it| list(it, "mapping"));
            let pdo = mapped.chain(list(member, "pdos")).find(|pdo| number(pdo, "index") == index).unwrap();
            let entries = list(pdo, "entries").iter();
            lines.extend(entries.map(|entry| channel(member, entry, role == "outputs", &mut taken)));
        }
    }
    for manager in list(member, "sync_managers") {
        let role = text(manager, "role");
        let is_output = role == "outputs" || role == "mailbox_out";
        let carries = !role.starts_with("mailbox") && !assigned(member, configuration, role).is_empty();
        let pdo = if !carries {
            "-"
        } else if is_output {
            "rpdo"
        } else {
            "tpdo"
        };
        let watched = !role.starts_with("mailbox") && number(manager, "control") & 0x40 != 0;
        let (way, watched) =
            (if is_output { "output" } else { "input" }, if watched { "enable" } else { "disable" });
        lines.push(format!("sm {} {way} {pdo} {watched}", number(manager, "number")));
    }
    lines
}

fn assigned(member: &Json, configuration: Option<&Json>, role: &str) -> Vec<usize> {
    let chosen = configuration.and_then(|it| it[role].as_array().cloned());
    let manager = list(member, "sync_managers").iter().find(|it| text(it, "role") == role);
    let pdos = chosen.unwrap_or_else(|| manager.map_or(Vec::new(), |it| list(it, "pdos").to_vec()));
    pdos.iter().map(|index| usize::try_from(index.as_u64().unwrap()).unwrap()).collect()
}

/// What CiA 402 has at an index of the first axis, and what controllers of ROS 2 call it; the plug-in takes words and modes.
const ROLES: &[(usize, &str)] = &[
    (0x6040, "-"),
    (0x6041, "-"),
    (0x6060, "-"),
    (0x6061, "-"),
    (0x607A, "position"),
    (0x6064, "position"),
    (0x60FF, "velocity"),
    (0x606C, "velocity"),
    (0x6071, "effort"),
    (0x6077, "effort"),
];

/// Names of interfaces can be as long as they like.
fn whole_name(id: &str) -> String {
    id.to_lowercase().replace('-', "_")
}

/// `taken` has how often each name was there before: of a value that is mapped again, the name has a number.
fn channel(member: &Json, mapped: &Json, is_output: bool, taken: &mut BTreeMap<String, usize>) -> String {
    let bits = number(mapped, "bits");
    if mapped["address"].is_null() {
        return format!("channel 0 0 {bits} bit{bits} - - 1");
    }
    let (index, subindex) = (number(&mapped["address"], "index"), number(&mapped["address"], "subindex"));
    let object = list(member, "objects").iter().find(|it| number(it, "index") == index);
    let axes = list(member, "axes");
    let axis = object.and_then(|it| it["axis"].as_u64()).map_or(0, |axis| usize::try_from(axis).unwrap());
    let several = axes.len() > 1;
    let role = ROLES.iter().find(|(known, _)| !several && subindex == 0 && *known == index);
    let prefix = object
        .filter(|it| several && !it["axis"].is_null())
        .map(|_| whole_name(text(&axes[axis], "name")) + "_");
    let own = prefix.unwrap_or_default() + &whole_name(text(mapped, "id"));
    let times = taken.entry(own.clone()).or_default();
    *times += 1;
    let own = if *times > 1 { format!("{own}_{times}") } else { own };
    let is_word = word(member, &mapped["address"]).is_some();
    let data_type = mapped["data_type"].as_str().unwrap_or("UINT");
    let whole = !data_type.starts_with("REAL") && !data_type.contains("STRING");
    let kind = match bits {
        1 if whole => "bool".to_owned(),
        8 | 16 | 32 | 64 if whole && data_type.starts_with("INT") && !is_word => format!("int{bits}"),
        8 | 16 | 32 | 64 if whole => format!("uint{bits}"),
        _ => return format!("channel {index} {subindex} {bits} bit{bits} - - 1"),
    };
    let interface = role.map_or(own, |(_, role)| (*role).to_owned());
    let default = if interface == "position" && is_output && role.is_some() { "nan" } else { "-" };
    let si = scale(member, mapped).filter(|_| interface != "-").unwrap_or(1.0);
    let factor = if is_output { 1.0 / si } else { si };
    format!("channel {index} {subindex} {bits} {kind} {interface} {default} {factor:e}")
}

/// Metres, radians, these in a second, and newton metres for one raw step.
fn scale(member: &Json, mapped: &Json) -> Option<f64> {
    let (symbol, ratio) = step(member, mapped)?;
    let degree = std::f64::consts::PI / 180.0;
    let own = match symbol {
        "m" | "m/s" | "Nm" | "N" => 1.0,
        "mm" | "mm/s" | "mNm" | "mN" => 1e-3,
        "µm" | "µm/s" => 1e-6,
        "deg" | "deg/s" | "°" | "°/s" => degree,
        "mdeg" | "mdeg/s" => 1e-3 * degree,
        "rpm" => 6.0 * degree,
        "rev" => 360.0 * degree,
        _ => return None,
    };
    Some(own * ratio)
}
