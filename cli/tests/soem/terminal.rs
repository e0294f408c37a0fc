//! What stands on a terminal while devices run: `script`, of util-linux, is one.

use std::process::Command;

use super::{DEVICES, Network};

/// What a terminal got, with the escapes.
fn typed(network: &Network, arguments: &str) -> String {
    let devc = env!("CARGO_BIN_EXE_devc");
    let mut script = network.command("script");
    let command = format!("stty cols 120 rows 40; {devc} run --interface {DEVICES} {arguments}");
    let ran =
        script.args(["-qec", &command, "/dev/null"]).env("TERM", "xterm").output().expect("script runs");
    assert!(ran.status.success(), "{ran:?}");
    String::from_utf8(ran.stdout).expect("text")
}

#[test]
fn a_terminal_has_a_table_that_is_kept_up_to_date() {
    let has_script = Command::new("script").arg("--version").output().is_ok_and(|ran| ran.status.success());
    if !has_script {
        eprintln!("skipped: there is no `script`");
        return;
    }
    let Some(network) = Network::new("terminal") else {
        eprintln!("skipped: no network namespace can be made, which takes root");
        return;
    };
    let typed = typed(&network, "devices/c887 --fault U=0x7305@200ms --for 600ms");
    let rows: Vec<&str> = typed.lines().map(str::trim_end).collect();
    let words = |row: &str| row.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let is_head =
        |row: &&str| words(row) == ["device", "state", "axis", "state", "position", "error", "mode"];
    assert!(rows.iter().any(is_head), "{typed}");
    // a head and six axes are drawn anew in their place
    assert!(typed.contains("\u{1b}[7A\r\u{1b}[J"), "{typed:?}");
    let last = rows.rsplit(is_head).next().expect("the last table");
    assert_eq!(last.len(), 6, "{last:?}");
    assert_eq!(words(last[3])[..5], ["U", "fault", "0.00000", "deg", "0x7305"]);
    // what went wrong stands above, and stays
    assert!(
        rows.iter()
            .any(|row| row.contains("c887: U: fault") && row.ends_with("error 0x7305, at 0.00000 deg")),
        "{typed}"
    );
}
