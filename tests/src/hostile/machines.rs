//! Many states, commands, transitions and modes.

use super::{Files, Kind, each, list, one};

pub(super) const KINDS: &[Kind] = &[
    Kind { name: "states", files: |n| one(states(n)) },
    Kind {
        name: "states of one pattern",
        files: |n| {
            one(each(n, |i| format!("[states.s{i}]\nname=\"S{i}\"\npattern=\"xxxx xxxx x0xx 0000\"\n")))
        },
    },
    Kind { name: "commands of one pattern", files: |n| one(each(n, |i| command(i, "0xxx x110", "2,6,8"))) },
    Kind { name: "commands", files: |n| one(each(n, |i| command(i, &format!("{:08b}", i % 256), ""))) },
    Kind { name: "commands that lead everywhere", files: everywhere },
    Kind {
        name: "transitions",
        files: |n| {
            let next = |i| format!("[transitions.{i}]\nfrom=\"s{i}\"\nto=\"s{}\"\n", i + 1);
            one(states(n + 1) + &each(n, next))
        },
    },
    Kind {
        name: "transitions to nowhere",
        files: |n| one(states(n) + &each(n, |i| format!("[transitions.{i}]\nfrom=\"s{i}\"\nto=\"t{i}\"\n"))),
    },
    Kind {
        name: "states of a transition",
        files: |n| one(states(n) + &format!("[transitions.1]\nto=\"s0\"\nfrom=[{}]", names(n))),
    },
    Kind {
        name: "states in which a command is ignored",
        files: |n| one(states(n) + &format!("[commands.x]\nname=\"X\"\nignored-in=[{}]", names(n))),
    },
    Kind {
        name: "events of a transition",
        files: |n| {
            one(states(2) + &format!("[transitions.1]\nto=\"s1\"\nevents=[{}]", "\"fault\",".repeat(n)))
        },
    },
    Kind {
        name: "letters of a pattern",
        files: |n| one(format!("[states.x]\nname=\"S\"\npattern=\"{}\"", "x".repeat(10 * n))),
    },
    Kind { name: "modes", files: |n| one(each(n, |i| format!("[modes.{i}]\nid=\"m{i}\"\nname=\"M{i}\"\n"))) },
    Kind {
        name: "aliases of a mode",
        files: |n| one(format!("[modes.8]\naliases=[{}]", list(n, |i| (i % 30_000).to_string()))),
    },
    Kind {
        name: "bits of a mode",
        files: |n| one(format!("[modes.8]\ncontrol-bits={{{}}}", list(n, |i| format!("{i}=\"B{i}\"")))),
    },
    Kind {
        name: "aliases of a homing method",
        files: |n| {
            one(format!("[homing-methods.1]\nname=\"x\"\naliases=[{}]", list(n, |i| (i % 128).to_string())))
        },
    },
];

fn states(count: usize) -> String {
    each(count, |i| format!("[states.s{i}]\nname=\"S\"\n"))
}

fn names(count: usize) -> String {
    list(count, |i| format!("\"s{i}\""))
}

fn command(number: usize, low: &str, transitions: &str) -> String {
    format!(
        "[commands.c{number}]\nname=\"C{number}\"\npattern=\"xxxx xxxx {low}\"\ntransitions=[{transitions}]\n"
    )
}

/// Commands with one pattern, each of which sets off all transitions, which all start in all states.
fn everywhere(count: usize) -> Files {
    let count = count.isqrt().min(250);
    let all = names(count);
    let transitions = each(count, |i| format!("[transitions.{i}]\nfrom=[{all}]\nto=\"s0\"\n"));
    let numbers = list(count, |i| i.to_string());
    one(states(count) + &transitions + &each(count, |i| command(i, "0xxx x110", &numbers)))
}
