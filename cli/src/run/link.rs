//! The network interface, and what may be wrong with it.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

use devc_virtual::Interface;

use crate::outcome::{Failure, reason};

/// Where Linux shows its interfaces.
const INTERFACES: &str = "/sys/class/net";

/// Opens an interface, or says what stands in the way and how to clear it.
pub(super) fn open(name: &str) -> Result<Interface, Failure> {
    let interface = Interface::open(name).map_err(|error| refused(name, &error))?;
    if shown(name, "flags").is_some_and(|flags| !is_up(&flags)) {
        let what = format!("the network interface `{name}` is down");
        return Err(Failure::new(what).help(format!("`sudo ip link set {name} up` brings it up")));
    }
    Ok(interface)
}

/// What to say if nothing is at the other end.
pub(super) fn remark(name: &str) -> Option<String> {
    let has_link = shown(name, "carrier").is_none_or(|carrier| carrier != "0");
    let what = format!("{name} has no link: no cable, or its other end is down; frames come once it has one");
    (!has_link).then_some(what)
}

fn refused(name: &str, error: &io::Error) -> Failure {
    let what = format!("cannot open the network interface `{name}`: {}", reason(error));
    if error.kind() == ErrorKind::PermissionDenied {
        let path =
            std::env::current_exe().map_or_else(|_| "devc".to_owned(), |path| path.display().to_string());
        let how = format!("raw sockets take a right: run it as root, or `sudo setcap cap_net_raw+ep {path}`");
        return Failure::new(what).help(how);
    }
    let names = names();
    let failure = Failure::new(what).help(format!(
        "`ip link` lists the interfaces; `sudo ip link add {name} type veth peer name {name}-master` makes a virtual cable"
    ));
    if names.is_empty() { failure } else { failure.choices(&names) }
}

/// The interfaces that there are.
fn names() -> Vec<String> {
    let entries = fs::read_dir(INTERFACES).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries.map(|entry| format!("  {}", entry.file_name().display())).collect();
    names.sort();
    names
}

/// What Linux shows of an interface.
fn shown(name: &str, what: &str) -> Option<String> {
    Some(fs::read_to_string(Path::new(INTERFACES).join(name).join(what)).ok()?.trim().to_owned())
}

/// Whether the flags of an interface, in hexadecimal, have the first.
fn is_up(flags: &str) -> bool {
    u32::from_str_radix(flags.trim_start_matches("0x"), 16).is_ok_and(|flags| flags & 1 != 0)
}
