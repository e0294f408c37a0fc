//! SOEM, by pysoem, as the master of `devc run`: over two ends of a virtual cable, in a network namespace that the test makes.
//!
//! Skipped with a word where that cannot be: it takes root, Linux and the Python package `pysoem` (1.1.13).
#![cfg(target_os = "linux")]
#![allow(clippy::expect_used, clippy::unwrap_used, clippy::panic, clippy::print_stderr)] // a test may

mod configurations;
mod dictionary;
mod terminal;

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};

use serde_json::{Value, json};

const PYTHON: &str = "python3";

/// The ends of the cable.
const MASTER: &str = "veth-master";
const DEVICES: &str = "veth-devices";

/// All devices that are shipped, in the order of the cable.
const NINE: [&str; 3] = ["devices/c887", "devices/s700", "devices/pmc-sc6"];

/// A network namespace with a cable in it, and the devices at one end.
struct Network {
    name: String,
    devc: Option<Child>,
    /// One after the other: two masters and their devices are more than some machines do in time.
    _turn: MutexGuard<'static, ()>,
}

static TURN: Mutex<()> = Mutex::new(());

impl Network {
    /// None where the kernel does not allow it.
    fn new(name: &str) -> Option<Self> {
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let name = format!("devc-{name}-{}", std::process::id());
        ip(&["netns", "add", &name])?;
        let network = Self { name, devc: None, _turn: turn };
        let link = |arguments: &[&str]| {
            let command = [&["-n", &network.name, "link"], arguments].concat();
            ip(&command).unwrap_or_else(|| panic!("ip {command:?}"));
        };
        link(&["add", MASTER, "type", "veth", "peer", "name", DEVICES]);
        link(&["set", MASTER, "up"]);
        link(&["set", DEVICES, "up"]);
        Some(network)
    }

    fn command(&self, program: &str) -> Command {
        let mut command = Command::new("ip");
        command.args(["netns", "exec", &self.name, program]).current_dir(workspace());
        command
    }

    /// Starts devc, and waits until it says that it waits.
    fn run(&mut self, arguments: &[&str]) {
        let mut command = self.command(env!("CARGO_BIN_EXE_devc"));
        command.args(["run", "--interface", DEVICES, "--for", "2min"]).args(arguments);
        let mut devc = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("devc runs");
        let told = BufReader::new(devc.stderr.take().expect("a pipe"));
        self.devc = Some(devc);
        assert!(told.lines().any(|line| line.expect("text").contains("waiting for a master")));
    }

    /// Lets SOEM bring all to Operational and cycle, then move so many axes of the first; tells what it saw.
    fn master(&self, cycles: u32, axes: usize) -> Value {
        let script = "cli/tests/soem/master.py";
        let master = self
            .command(PYTHON)
            .args(["-B", script, MASTER, &cycles.to_string(), &axes.to_string()])
            .output();
        let master = master.expect("Python runs");
        let said = String::from_utf8_lossy(&master.stderr);
        assert!(master.status.success(), "{said}{}", String::from_utf8_lossy(&master.stdout));
        serde_json::from_slice(&master.stdout).expect("JSON")
    }

    /// Lets SOEM do what a script has it do, and tells what that says of each subdevice or round.
    fn ask(&self, script: &str, asked: &Value) -> Vec<Value> {
        let mut master = self.command(PYTHON);
        let master = master.args(["-B", &format!("cli/tests/soem/{script}"), MASTER]);
        let master = master.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut master = master.spawn().expect("Python runs");
        let mut questions = master.stdin.take().expect("a pipe");
        questions.write_all(asked.to_string().as_bytes()).expect("it is read");
        drop(questions);
        let told = master.wait_with_output().expect("it ends");
        assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
        serde_json::from_slice(&told.stdout).expect("JSON")
    }
}

impl Network {
    /// Ends devc, if it has not ended.
    fn stop(&mut self) {
        if let Some(mut devc) = self.devc.take() {
            let _ = devc.kill();
            let _ = devc.wait();
        }
    }
}

impl Drop for Network {
    fn drop(&mut self) {
        self.stop();
        ip(&["netns", "delete", &self.name]);
    }
}

fn ip(arguments: &[&str]) -> Option<()> {
    let ran = Command::new("ip").args(arguments).stderr(Stdio::null()).status().ok()?;
    ran.success().then_some(())
}

fn workspace() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace")
}

/// A network, if everything is there that the test needs.
fn network(name: &str) -> Option<Network> {
    let has_soem = Command::new(PYTHON).args(["-c", "import pysoem"]).stderr(Stdio::null()).status();
    if !has_soem.is_ok_and(|status| status.success()) {
        eprintln!("skipped: `{PYTHON} -c 'import pysoem'` fails; `pip install pysoem==1.1.13`");
        return None;
    }
    let network = Network::new(name);
    if network.is_none() {
        eprintln!("skipped: no network namespace can be made, which takes root");
    }
    network
}

/// What the manuals say: vendor (PI, p. 21 of the EtherCAT manual), and 42 and 66 bytes of process data by default (p. 24).
#[test]
fn the_hexapod_runs_with_clocks_and_its_axes_follow() {
    let Some(mut network) = network("hexapod") else { return };
    network.run(&["devices/c887"]);
    let seen = network.master(10_000, 6);
    assert_eq!(seen["count"], 1);
    assert_eq!(seen["devices"][0]["identity"], json!([0x076D, 3, 0]));
    assert_eq!(seen["devices"][0]["type"].as_u64().expect("a number") & 0xFFFF, 402);
    assert_eq!(seen["devices"][0]["lengths"], json!([42, 66]));
    assert_eq!((&seen["cycles"], &seen["wrong"], &seen["states"]), (&json!(10_000), &json!(0), &json!([8])));
    // each axis is led another way, and is there when it has stopped
    assert_eq!(seen["moved"]["asked"], json!([200, 400, 600, 800, 1000, 1200]));
    assert_eq!(seen["moved"]["gone"], seen["moved"]["asked"]);
}

#[test]
fn both_axes_of_the_pilz_drive_are_moved() {
    let Some(mut network) = network("double") else { return };
    network.run(&["devices/pmc-sc6", "--member", "double"]);
    let seen = network.master(100, 2);
    assert_eq!(seen["moved"]["asked"], json!([200, 400]));
    assert_eq!(seen["moved"]["gone"], seen["moved"]["asked"]);
}

#[test]
fn nine_devices_on_one_cable_come_to_operational() {
    let Some(mut network) = network("nine") else { return };
    network.run(&NINE);
    let seen = network.master(1_000, 0);
    assert_eq!(seen["count"], 9);
    // SOEM reads the EEPROM of one of several with the same identity, and so calls all S devices as the first
    let names: Vec<&Value> =
        seen["devices"].as_array().expect("a list").iter().map(|it| &it["name"]).collect();
    let expected = dictionary::described().into_iter().map(|device| {
        if device.type_name.starts_with('S') && device.type_name.len() == 4 {
            "S300".to_owned()
        } else {
            device.type_name
        }
    });
    assert_eq!(names, expected.map(Value::from).collect::<Vec<_>>().iter().collect::<Vec<_>>());
    let lengths: Vec<&Value> =
        seen["devices"].as_array().expect("a list").iter().map(|it| &it["lengths"]).collect();
    let expected = [[42, 66], [6, 6], [6, 6], [6, 6], [6, 6], [46, 58], [23, 29], [46, 58], [23, 29]];
    assert_eq!(lengths, expected.map(|lengths| json!(lengths)).iter().collect::<Vec<_>>());
    assert_eq!((&seen["wrong"], &seen["states"]), (&json!(0), &json!(vec![8; 9])));
}

/// CiA 301: `save` in 0x1010:01 stores all.
#[test]
fn what_a_master_stores_is_there_in_the_next_run() {
    let Some(mut network) = network("stored") else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("stored.json");
    let arguments = ["virtual/tests/shared/own.toml", "--store", file.to_str().expect("text")];
    network.run(&arguments);
    let writes = json!([[[[0x2000, 0, "0900"], [0x1010, 1, "73617665"]]]]);
    assert_eq!(network.ask("configure.py", &writes)[0]["states"], json!([8]));
    network.stop();
    network.run(&arguments);
    let read = network.ask("dictionary.py", &json!([[[[0x2000, 0], [0x1010, 1]], false]]));
    assert_eq!(read[0]["values"], json!(["0900", "01000000"]));
}
