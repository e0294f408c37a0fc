//! `devc run`, as far as it goes without a network.

use super::{Desk, SOUND};

#[test]
fn an_interface_that_there_is_not_is_told() {
    let desk = Desk::sound();
    desk.devc(&["run", "devices/drive", "--interface", "none"])
        .ends(2, &["cannot open the network interface `none`: no such device", "ip link add none type veth"]);
    desk.devc(&["run", "devices/drive"]).ends(2, &["--interface"]);
    desk.devc(&["run", "--interface", "none"]).ends(2, &["PATH"]);
}

#[test]
fn a_description_with_errors_does_not_run() {
    let desk = Desk::sound();
    desk.put("devices/drive/device.toml", "[device]\nname = 1");
    desk.devc(&["run", "devices/drive", "--interface", "none"]).ends(1, &["error"]);
}

/// A trace is a new file: what `--trace` is put in front of by mistake stays as it is.
#[test]
fn a_trace_replaces_nothing() {
    let desk = Desk::sound();
    desk.put("frames.pcapng", "mine");
    for name in ["frames.pcapng", "devices/drive/device.toml", "devices"] {
        desk.devc(&["run", "devices/drive", "-i", "none", "--trace", name])
            .ends(2, &[&format!("`{name}` is there already"), "--trace"]);
    }
    assert_eq!(desk.read("frames.pcapng"), "mine");
    assert_eq!(desk.read("devices/drive/device.toml"), SOUND);
}

#[test]
fn what_is_not_there_is_not_chosen() {
    let desk = Desk::sound();
    desk.devc(&["run", "devices/drive", "-i", "none", "--member", "other"])
        .ends(2, &["no description has a member `other`", "  drive"]);
    desk.devc(&["run", "devices/drive", "-i", "none", "--fault", "Q=0x7305@5s"])
        .ends(2, &["no axis has the name `Q`"]);
    desk.devc(&["run", "devices/drive", "-i", "none", "--fault", "Q=0x7305@5"])
        .ends(2, &["a time has a unit"]);
}
