//! Descriptions with more faults than anybody reads.

use std::time::{Duration, Instant};

use crate::{Desk, SOUND};

/// A sound description with so many objects whose access is misspelled.
fn misspelled(count: usize) -> String {
    let object = |n| {
        format!("[objects.0x{:04X}]\nname = \"Value {n}\"\ntype = \"UINT8\"\nacess = \"ro\"\n", 0x2001 + n)
    };
    SOUND.to_owned() + &(0..count).map(object).collect::<String>()
}

/// A sound description with so many objects of one name, which is a warning for each but the first.
fn alike(count: usize) -> String {
    let object = |n| format!("[objects.0x{:04X}]\nname = \"Speed\"\ntype = \"UINT8\"\n", 0x2001 + n);
    SOUND.to_owned() + &(0..count).map(object).collect::<String>()
}

#[test]
fn people_read_the_first_messages_of_a_rule_and_how_many_more_there_are() {
    let desk = Desk::new(&[("drive", &misspelled(2_019))]);
    for command in [&["check"][..], &["build"], &["check", "--format", "github"]] {
        let run = desk.devc(command);
        run.ends(1, &["and 1999 more of these"]);
        let said = format!("{}{}", run.out, run.err);
        assert_eq!(said.matches("unknown key `acess`").count(), 20, "{said}");
    }
    desk.devc(&["check"]).ends(1, &["devices/drive: 2019 errors"]);
    let run = desk.devc(&["check", "--limit", "5"]);
    run.ends(1, &["and 2014 more of these", "devices/drive: 2019 errors"]);
    assert_eq!(run.err.matches("unknown key `acess`").count(), 5, "{}", run.err);
}

#[test]
fn programs_get_all_of_them_unless_they_ask_for_less() {
    let desk = Desk::new(&[("drive", &misspelled(2_019))]);
    for format in ["json", "sarif"] {
        let all = desk.devc(&["check", "--format", format]);
        assert_eq!(all.out.matches("unknown key `acess`").count(), 2_019, "{format}");
        let some = desk.devc(&["check", "--format", format, "--limit", "5"]);
        assert_eq!(some.out.matches("unknown key `acess`").count(), 5, "{format}");
        some.ends(1, &["and 2014 more of these"]);
    }
}

#[test]
fn a_limit_of_nothing_is_none() {
    let desk = Desk::sound();
    desk.devc(&["check", "--limit", "0"]).ends(2, &["--limit"]);
}

#[test]
fn a_fix_and_a_baseline_see_all_messages() {
    let desk = Desk::new(&[("drive", &misspelled(100))]);
    desk.devc(&["check", "--fix"]).ends(0, &["made 100 edits"]);
    let desk = Desk::new(&[("drive", &alike(100))]);
    let baseline = ["check", "--baseline", "known.json"];
    desk.devc(&[&baseline[..], &["--update-baseline"]].concat()).ends(0, &["100 known findings"]);
    desk.devc(&baseline).ends(0, &["no new findings"]);
    desk.put("devices/drive/device.toml", alike(101));
    desk.devc(&baseline).ends(0, &["0x2065", "1 warning"]);
}

/// What a folder or a file is called is said as text, and no folder is called what no output can hold.
#[test]
#[cfg(unix)]
fn names_of_files_are_not_obeyed() {
    let name = "a\u{1B}[31m\n::error::b\u{9B}\u{202E}";
    let desk = Desk::new(&[(name, SOUND)]);
    let path = format!("devices/{name}");
    let toml = format!("{path}/device.toml");
    let commands = [
        &["check", &path][..],
        &["build", &path],
        &["check", "--format", "github", &path],
        &["check", "--format", "json", &toml],
        &["check", "--format", "sarif", &toml],
        &["check", "--baseline", name, &path],
        &["check", &format!("{path}/nothing")],
        &["build", "--out", &toml, &path],
    ];
    for command in commands {
        let run = desk.devc(command);
        let said = format!("{}{}", run.out, run.err);
        let odd = said.chars().find(|c| *c != '\n' && devc::text::characters::hazard(*c).is_some());
        assert_eq!(odd, None, "{command:?} says {said:?}");
        let obeyed =
            said.lines().filter(|line| line.starts_with("::") && !line.starts_with("::error title="));
        assert_eq!(obeyed.count(), 0, "{command:?} says {said:?}");
    }
    let refused = "error[forbidden-character]: the folder `a\\u{1B}[31m\\n::error::b\\u{9B}\\u{202E}` has U+001B in its name";
    desk.devc(&["check", &path]).ends(1, &[refused]);
}

/// What asks for much work by little text, each with the limit that the message names.
#[test]
fn what_is_too_large_is_refused_by_a_limit_that_is_named() {
    let each = |count: usize, text: &dyn Fn(usize) -> String| (0..count).map(text).collect::<String>();
    let includes = each(20_000, &|n| format!("\"part{n}.toml\","));
    let bits = each(10_000, &|n| format!("{n} = \"Bit {n}\","));
    let sound = |more: String| SOUND.to_owned() + &more;
    let cases = [
        (format!("include = [{includes}]\n{SOUND}"), "a description can have 1000"),
        (
            sound(each(2_000, &|n| format!("[members.m{n}.device]\nname = \"M{n}\"\n"))),
            "a family can have 256",
        ),
        (sound(format!("[words.statusword]\nbits = {{ {bits} }}\n")), "a table like this can have 4096"),
        (
            sound(each(6_000, &|n| format!("[states.s{n}]\nname = \"S{n}\"\npattern = \"xxxx xxxx\"\n"))),
            "it can have 1024",
        ),
        (
            sound(format!("[objects.0x2001]\nname = \"{}\"\n", "x".repeat(1 << 20))),
            "a text can have 65536 bytes",
        ),
        (sound("a = 1\n".repeat(4_000)), "and 3979 more of these"),
        (sound("=\n".repeat(20_000)), "more of these"),
    ];
    for (text, limit) in cases {
        let desk = Desk::new(&[("drive", &text)]);
        let start = Instant::now();
        let run = desk.devc(&["check"]);
        run.ends(1, &[limit]);
        assert!(run.err.lines().count() < 1_000, "{limit}: {} lines", run.err.lines().count());
        // a hundred times as long as it takes, and a fraction of what it took when all was compared with all
        assert!(start.elapsed() < Duration::from_secs(60), "{limit}: {:?}", start.elapsed());
    }
}
