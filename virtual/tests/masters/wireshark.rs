//! The trace of a master at a drive, read by Wireshark with the dissector of the drive: what it shows is what the master
//! has sent and received.
#![allow(clippy::print_stderr)] // what is not asked is said

use std::cell::RefCell;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use devc::emit::wireshark::Wireshark;
use devc::emit::{Emitter, Options};
use devc::source::Disk;
use devc_virtual::{Trace, Way};
use tempfile::TempDir;

use crate::bus::traced;
use crate::session::Session;
use crate::shared::device;

/// The values of fields in the frames in which there are any, one line a frame.
fn read(folder: &TempDir, fields: &[&str]) -> Vec<Vec<String>> {
    let mut tshark = Command::new("tshark");
    tshark.current_dir(folder).args(["-r", "trace", "-X", "lua_script:device.lua", "-T", "fields"]);
    tshark.args(["-Y", &fields.join(" or ")]).args(fields.iter().flat_map(|field| ["-e", field]));
    let output = tshark.output().expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && !said.contains("Lua"), "{said}");
    let text = String::from_utf8(output.stdout).expect("text");
    text.lines().map(|line| line.split('\t').map(str::to_owned).collect()).collect()
}

/// The values of one field, each only where it changes.
fn changes(folder: &TempDir, field: &str) -> Vec<String> {
    let mut values: Vec<String> = read(folder, &[field]).into_iter().map(|mut line| line.remove(0)).collect();
    values.dedup();
    values
}

/// A folder with the trace of a run and the dissector of the device; the targets and positions of the first axis that the
/// master saw.
fn recorded(family: &str, id: &'static str) -> (TempDir, Vec<i64>, Vec<i64>) {
    let folder = tempfile::tempdir().expect("a folder");
    let description = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(family);
    let compiled = devc::compile(&Disk, &description).family.expect("it compiles");
    let files = Wireshark.emit(&compiled, &Options::default()).0;
    std::fs::write(folder.path().join("device.lua"), &files[&format!("{id}.lua")]).expect("a file");
    let file = std::fs::File::create(folder.path().join("trace")).expect("a file");
    let trace = RefCell::new(Trace::begin(file, "wire", "a test").expect("it begins"));
    let keep = |[gone, come]: [&[u8]; 2]| {
        let mut trace = trace.borrow_mut();
        trace.frame(Duration::ZERO, Way::In, gone).expect("it is written");
        trace.frame(Duration::ZERO, Way::Out, come).expect("it is written");
    };
    let chosen = device(id).configurations.iter().find(|configuration| configuration.default);
    let (mut targets, mut positions) = (Vec::new(), Vec::new());
    traced(
        device(id),
        |_| (),
        keep,
        async |master| {
            let mut session = Session::begin(master, device(id), chosen).await;
            session.enable().await;
            session.select(8).await;
            for step in 1..=40 {
                targets.push(step * 3 - 60);
                session.set(0, 0x607A, step * 3 - 60).await;
                session.cycles(1).await;
                positions.push(session.get(0, 0x6064).await);
            }
            session.command(0x06).await;
        },
    );
    trace.borrow_mut().flush().expect("it is written");
    (folder, targets, positions)
}

#[test]
fn wireshark_shows_what_the_master_did() {
    if !Command::new("tshark").arg("--version").output().is_ok_and(|it| it.status.success()) {
        eprintln!("skipped, since there is no tshark");
        return;
    }
    for (family, id, prefix) in
        [("c887", "c887", "devc_c887.x"), ("pmc-sc6", "double", "devc_pmc_sc6_double.a")]
    {
        let (folder, targets, positions) = recorded(family, id);
        let field = |name: &str| format!("{prefix}.{name}");
        let states = changes(&folder, &field("statusword.state"));
        // CiA 402, transitions 2, 3, 4 and 6
        let way = [
            "Switch on disabled",
            "Ready to switch on",
            "Switched on",
            "Operation enabled",
            "Ready to switch on",
        ];
        let way = way.map(str::to_lowercase);
        let states: Vec<String> = states.iter().map(|state| state.to_lowercase()).collect();
        assert!(states.ends_with(&way), "{id}: {states:?}");
        let numbers = |name: &str| -> Vec<i64> {
            changes(&folder, &field(name)).iter().map(|text| text.parse().expect("a number")).collect()
        };
        let sent = numbers("target_position");
        assert!(sent.windows(targets.len()).any(|window| window == targets), "{id}: {sent:?}");
        let mut positions = positions.clone();
        positions.dedup();
        let received = numbers("position_actual_value");
        assert!(received.windows(positions.len()).any(|window| window == positions), "{id}: {received:?}");
        let device = prefix.split_once('.').expect("two parts").0;
        let al = changes(&folder, &format!("{device}.al.state"));
        assert!(al.ends_with(&["Safe-Operational".to_owned(), "Operational".to_owned()]), "{id}: {al:?}");
        assert_eq!(read(&folder, &[&format!("{device}.mismatch")]), Vec::<Vec<String>>::new(), "{id}");
    }
}
