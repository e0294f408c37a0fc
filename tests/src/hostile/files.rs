//! Many of what a TOML file consists of, right and wrong, and many files.

use super::{Files, HEAD, Kind, each, list, objects, one, whole};

pub(super) const KINDS: &[Kind] = &[
    Kind { name: "the same key again", files: |n| one("[objects.0x2000]\n".to_owned() + &"a=1\n".repeat(n)) },
    Kind { name: "the same table again", files: |n| one("[objects.0x2000]\n".repeat(n)) },
    Kind {
        name: "the same key again in braces",
        files: |n| one(format!("x={{{}}}", list(n, |_| "a=1".into()))),
    },
    Kind { name: "the same key again with dots", files: |n| one("a.b.c=1\n".repeat(n)) },
    Kind {
        name: "the same key again beside deep brackets",
        files: |n| one("a=1\n".repeat(3) + "x=" + &"[".repeat(n) + &"]".repeat(n)),
    },
    Kind { name: "lines without a key", files: |n| one("=\n".repeat(n)) },
    Kind { name: "words that are nothing", files: |n| one("a b c\n".repeat(n)) },
    Kind { name: "elements without a value", files: |n| one(format!("x=[{}]", "=,".repeat(n))) },
    Kind { name: "numbers without digits", files: |n| one(format!("x=[{}]", "0x,".repeat(n))) },
    Kind { name: "brackets in brackets", files: |n| one("x=".to_owned() + &"[".repeat(n) + &"]".repeat(n)) },
    Kind {
        name: "braces in braces",
        files: |n| one("x=".to_owned() + &"{a=".repeat(n) + "1" + &"}".repeat(n)),
    },
    Kind { name: "brackets that stay open", files: |n| one("x=".to_owned() + &"[".repeat(n)) },
    Kind { name: "braces that stay open", files: |n| one("x=".to_owned() + &"{a=".repeat(n)) },
    Kind { name: "dots in a key", files: |n| one(format!("x{}=1", ".a".repeat(n))) },
    Kind { name: "dots in a header", files: |n| one(format!("[x{}]", ".a".repeat(n))) },
    Kind { name: "deep headers", files: |n| one(each(n / 10, |i| format!("[x{}.b{i}]\n", ".a".repeat(25)))) },
    Kind { name: "elements of an array", files: |n| one(format!("x=[{}]", "1,".repeat(n))) },
    Kind { name: "tables of an array", files: |n| one("[[x]]\n".repeat(n)) },
    Kind { name: "tables in a table", files: |n| one(each(n, |i| format!("[x.a{i}]\n"))) },
    Kind { name: "letters of a key", files: |n| one(format!("{}=1", "x".repeat(20 * n))) },
    Kind {
        name: "letters of a name",
        files: |n| one(objects(1, |_| format!("name=\"{}\"", "x".repeat(20 * n)))),
    },
    Kind {
        name: "escapes of a text",
        files: |n| one(format!("[words.x]\nabout=\"{}\"", "\\u0041".repeat(n))),
    },
    Kind {
        name: "forbidden escapes",
        files: |n| one(format!("[words.x]\nabout=\"{}\"", "\\u001B".repeat(n))),
    },
    Kind { name: "forbidden characters", files: |n| one("# \u{202E}\n".repeat(n)) },
    Kind { name: "empty lines", files: |n| one("\n".repeat(10 * n)) },
    Kind { name: "comments", files: |n| one(("# ".to_owned() + &"x".repeat(50) + "\n").repeat(n)) },
    Kind { name: "letters of a comment", files: |n| one("# ".to_owned() + &"x".repeat(50 * n) + "\nx=1") },
    Kind {
        name: "faults on one line",
        files: |n| one(format!("[words.statusword]\nbits={{{}}}", list(n, |i| format!("{i}=\"B\"")))),
    },
    Kind { name: "unknown sections", files: |n| one(each(n, |i| format!("[object{i}]\n"))) },
    Kind { name: "unknown keys", files: |n| one(objects(1, |_| each(n, |i| format!("nam{i}=1\n")))) },
    Kind {
        name: "unknown rules",
        files: |n| one("[lints]\n".to_owned() + &each(n, |i| format!("unsourced-fac{i}=\"warn\"\n"))),
    },
    Kind {
        name: "unknown profiles",
        files: |n| whole(format!("profiles=[{}]", list(n, |i| format!("\"p{i}\"")))),
    },
    Kind {
        name: "values of the wrong type",
        files: |n| one(each(n, |i| format!("[objects.0x{:04X}]\nname=1\n", 0x2000 + i))),
    },
    Kind { name: "includes", files: |n| including(n, "", true) },
    Kind { name: "includes that are missing", files: |n| including(n, "", false) },
    Kind { name: "includes from outside", files: |n| including(n, "../", false) },
    Kind { name: "includes of one file", files: |n| including_one(n, "other.toml") },
    Kind { name: "includes of itself", files: |n| including_one(n, "device.toml") },
    Kind {
        name: "sections in two files",
        files: |n| in_two(n, |i| format!("[x{i}]\n"), |i| format!("[y{i}]\n")),
    },
    Kind { name: "objects in two files", files: |n| in_two(n, named, named) },
    Kind { name: "files with remarks", files: with_remarks },
];

fn named(number: usize) -> String {
    format!("[objects.0x{:04X}]\nname=\"x\"\ntype=\"UINT8\"\n", 0x2000 + number)
}

fn including(count: usize, folder: &str, there: bool) -> Files {
    let include = format!("include=[{}]\n", list(count, |i| format!("\"{folder}i{i}.toml\"")));
    let mut files = whole(include + HEAD);
    files.extend((0..count).filter(|_| there).map(|i| (format!("i{i}.toml"), String::new())));
    files
}

fn including_one(count: usize, name: &str) -> Files {
    let mut files = whole(format!("include=[{}]\n{HEAD}", list(count, |_| format!("\"{name}\""))));
    files.push(("other.toml".to_owned(), String::new()));
    files
}

fn in_two(count: usize, first: impl Fn(usize) -> String, second: impl Fn(usize) -> String) -> Files {
    let mut files = whole(format!("include=[\"other.toml\"]\n{HEAD}{}", each(count, first)));
    files.push(("other.toml".to_owned(), each(count, second)));
    files
}

fn with_remarks(count: usize) -> Files {
    let mut all = including((count / 10).min(900), "", true);
    for (_, text) in all.iter_mut().skip(1) {
        *text = "[[remarks]]\nat=\"0x2000\"\nkind=\"doubt\"\ntext=\"x\"\n".repeat(4);
    }
    all
}
