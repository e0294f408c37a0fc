//! Many values, bits, errors, errata, and other things to be said.

use super::{Files, Kind, each, list, objects, one};

pub(super) const KINDS: &[Kind] = &[
    Kind { name: "values", files: |n| with_values(&list(n, |i| format!("{i}=\"v{i}\""))) },
    Kind { name: "values of one name", files: |n| with_values(&list(n, |i| format!("{i}=\"v\""))) },
    Kind {
        name: "values in two notations",
        files: |n| with_values(&list(n, |i| format!("{i}=\"v\",0x{i:X}=\"v\""))),
    },
    Kind {
        name: "values of all subindices",
        files: |n| {
            let values = list(n, |i| format!("{i}=\"v{i}\""));
            one(objects(1, |_| format!("entries={{\"1..=255\"={{name=\"e\",values={{{values}}}}}}}")))
        },
    },
    Kind {
        name: "spellings of a bit",
        files: |n| bits(&list(n, |i| format!("\"0x{:0width$X}\"=\"B\"", i % 16, width = 1 + i / 16 % 200))),
    },
    Kind {
        name: "ranges of bits of a word",
        files: |n| bits(&list(n, |i| format!("\"{}..={}\"=\"B{i}\"", i % 60, 60 + i % 4))),
    },
    Kind { name: "bits that there are not", files: |n| bits(&list(n, |i| format!("{i}=\"B{i}\""))) },
    Kind {
        name: "values of a bit",
        files: |n| bits(&format!("1={{name=\"x\",values={{{}}}}}", list(n, |i| format!("{i}=\"v{i}\"")))),
    },
    Kind {
        name: "values in values",
        files: |n| bits(&("1=".to_owned() + &"{name=\"x\",values={1=".repeat(n) + "\"x\"" + &"}}".repeat(n))),
    },
    Kind { name: "errors", files: |n| one(each(n, |i| error(i, i))) },
    Kind {
        name: "ranges of errors in each other",
        files: |n| one(each(n, |i| error(i, 0xFFFF - i % 0x8000))),
    },
    Kind {
        name: "ranges of errors across each other",
        files: |n| one(each(n, |i| error(i, 0x7FFF + i % 0x8000))),
    },
    Kind {
        name: "vendor codes of an error",
        files: |n| {
            let codes = list(n, |i| i.to_string());
            let error = format!("[errors.0x1000]\nname=\"x\"\nvendor-codes=[{codes}]");
            one(each(n, |i| format!("[vendor-codes.{i}]\nname=\"E{i}\"\n")) + &error)
        },
    },
    Kind {
        name: "causes of a vendor code",
        files: |n| {
            one(format!("[vendor-codes.1]\nname=\"E\"\ncauses={{{}}}", list(n, |i| format!("{i}=\"v\""))))
        },
    },
    Kind {
        name: "registers",
        files: |n| {
            let register =
                |i| format!("[registers.0x{i:04X}]\nname=\"R{i}\"\nlength=1\necat=\"r\"\ndrive=\"r\"\n");
            one(each(n, register))
        },
    },
    Kind {
        name: "bits of a register",
        files: |n| {
            let bits = list(n, |i| format!("{i}=\"v{i}\""));
            one(format!("[registers.1]\nname=\"E\"\nlength=2\necat=\"r\"\ndrive=\"r\"\nbits={{{bits}}}"))
        },
    },
    Kind {
        name: "bytes of a telegram",
        files: |n| {
            one(format!("[telegrams.x]\nname=\"E\"\nbytes={{{}}}", list(n, |i| format!("{i}=\"v{i}\""))))
        },
    },
    Kind {
        name: "AL status codes",
        files: |n| one(each(n, |i| format!("[al-status-codes.0x{i:04X}]\nname=\"E{i}\"\n"))),
    },
    Kind {
        name: "groups of coordinates",
        files: |n| {
            let groups = each(n, |i| format!("g{i}={{name=\"x\",number={i}}}\n"));
            one("[coordinates]\nbase=0x2000\ngroup-size=2\n[coordinates.groups]\n".to_owned() + &groups)
        },
    },
    Kind {
        name: "parameters",
        files: |n| {
            let parameters = each(n, |i| format!("[parameters.A{i}]\nname=\"P{i}\"\n"));
            one("[coordinates]\nbase=0x2000\ngroup-size=2\n".to_owned() + &parameters)
        },
    },
    Kind {
        name: "documents",
        files: |n| {
            let documents = each(n.min(1_000), |i| format!("[documents.d{i}]\ntitle=\"D{i}\"\n"));
            let object = |i| format!("name=\"N{i}\"\nsource=\"d{}: p. 1\"", i % n.min(1_000));
            one(documents + &objects(n, object))
        },
    },
    Kind {
        name: "assumptions of an object",
        files: |n| one(objects(1, |_| format!("assumed={{{}}}", list(n, |i| format!("k{i}=\"x\""))))),
    },
    Kind { name: "assumptions", files: |n| one(objects(n, |i| format!("name=\"N{i}\"\nassumed=\"x{i}\""))) },
    Kind {
        name: "remarks",
        files: |n| {
            let remark =
                |i| format!("[[remarks]]\nat=\"0x{:04X}\"\nkind=\"doubt\"\ntext=\"a\"\n", 0x2000 + i);
            one(each(n, remark))
        },
    },
    Kind {
        name: "errata that answer",
        files: |n| one(alike(n) + &each(n, |i| erratum("ambiguous-name", 0x2000 + i))),
    },
    Kind {
        name: "errata that answer nothing",
        files: |n| one(alike(n) + &each(n, |i| erratum("ambiguous-name", i))),
    },
    Kind {
        name: "errata of unknown rules",
        files: |n| one(each(n, |i| erratum(&format!("unsourced-fac{i}"), i))),
    },
    Kind {
        name: "steps of a procedure",
        files: |n| {
            let steps = "{do=\"x\",object=\"0x6040\"},".repeat(n);
            one(format!("[procedures.p]\nname=\"P\"\nsteps=[{steps}]"))
        },
    },
    Kind {
        name: "lights",
        files: |n| {
            one(each(n, |i| format!("[leds.p{i}]\nname=\"P\"\npatterns=[{{shows=\"a\",means=\"b\"}}]\n")))
        },
    },
    Kind {
        name: "markup in a text",
        files: |n| one(objects(1, |_| format!("about=\"{}\"", "*_`<& 0x2000 ".repeat(n)))),
    },
    Kind {
        name: "what could be parameters in a text",
        files: |n| {
            let object = objects(1, |_| format!("about=\"{}\"", "A1-".repeat(n)));
            one(object + "\n[parameters.A7]\nname=\"P\"\n")
        },
    },
    Kind {
        name: "letters of a default",
        files: |n| {
            let (length, text) = (n.min(6_000) * 10, "x".repeat(n * 10));
            one(format!("[objects.0x2000]\nname=\"X\"\ntype=\"STRING({length})\"\ndefault=\"{text}\""))
        },
    },
    Kind {
        name: "bytes of an EEPROM",
        files: |n| one(format!("[eeprom]\nsize=2048\nconfig-data=\"{}\"", "00".repeat(n))),
    },
];

fn with_values(values: &str) -> Files {
    one(objects(1, |_| format!("name=\"X\"\nvalues={{{values}}}")).replace("UINT8", "UINT32"))
}

fn bits(bits: &str) -> Files {
    one(format!("[words.statusword]\nbits={{{bits}}}"))
}

fn error(first: usize, last: usize) -> String {
    let first = first % 0x8000;
    format!(
        "[errors.\"0x{first:04X}..=0x{:04X}\"]\nname=\"E{first}\"\nvendor-codes=[1,2,3]\n",
        last.max(first)
    )
}

fn alike(count: usize) -> String {
    objects(count, |_| "name=\"G\"".into())
}

fn erratum(rule: &str, at: usize) -> String {
    format!("[[errata]]\nrule=\"{rule}\"\nat=\"0x{at:04X}\"\nsays=\"a\"\nholds=\"b\"\nwhy=\"c\"\n")
}
