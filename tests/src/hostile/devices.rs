//! Many members, axes, objects and PDOs, and many references between them.

use super::{Files, HEAD, Kind, each, list, objects, one, whole};

pub(super) const KINDS: &[Kind] = &[
    Kind {
        name: "members",
        files: |n| family(each(n, |i| format!("[members.m{i}.device]\nname=\"M{i}\"\n"))),
    },
    Kind {
        name: "members that are like one",
        files: |n| family("[members.b]\n".to_owned() + &each(n, |i| format!("[members.m{i}]\nlike=\"b\"\n"))),
    },
    Kind {
        name: "members that are like none",
        files: |n| family(each(n, |i| format!("[members.m{i}]\nlike=\"x{i}\"\n"))),
    },
    Kind {
        name: "members with much in common",
        files: |n| {
            family(objects(n, |i| format!("name=\"N{i}\"")) + &each(200, |i| format!("[members.m{i}]\n")))
        },
    },
    Kind { name: "axes", files: |n| one(format!("[axes]\nnames=[{}]", list(n, |i| format!("\"a{i}\"")))) },
    Kind {
        name: "shifts",
        files: |n| {
            let shifts = "{range=\"0x2000..=0x2000\",by=1},".repeat(n);
            one(format!("[axes]\nnames=[\"a\"]\nshifts=[{shifts}]"))
        },
    },
    Kind {
        name: "objects on many axes",
        files: |n| one(axes(256) + &objects(n.min(0xE0), |i| format!("name=\"N{i}\""))),
    },
    Kind {
        name: "differing axes that there are not",
        files: |n| one(axes(2) + &objects(1, |_| each(n, |i| format!("per-axis.x{i}.name=\"y\"\n")))),
    },
    Kind { name: "differing axes of a large object", files: differing_axes },
    Kind {
        name: "differing units",
        files: |n| one(each(n, |i| format!("[units.x.per-axis.x{i}]\nsymbol=\"y\"\n"))),
    },
    Kind {
        name: "ranges of all subindices",
        files: |n| one(objects(n, |_| "kind=\"array\"\nentries={\"1..=255\"={name=\"e\"}}".into())),
    },
    Kind {
        name: "braces in a name for all subindices",
        files: |n| one(objects(1, |_| format!("entries={{\"1..=255\"={{name=\"{}\"}}}}", "{}".repeat(n)))),
    },
    Kind {
        name: "letters in texts for all subindices",
        files: |n| {
            let about = "x".repeat(1000);
            one(objects(n / 50, |_| format!("entries={{\"1..=255\"={{name=\"e\",about=\"{about}\"}}}}")))
        },
    },
    Kind { name: "objects", files: |n| one(objects(n, |i| format!("name=\"Gauge number {i}\""))) },
    Kind { name: "objects of one name", files: |n| one(objects(n, |_| "name=\"Gauge\"".into())) },
    Kind { name: "objects on one line", files: one_line },
    Kind {
        name: "objects without a type",
        files: |n| one(each(n, |i| format!("[objects.0x{:04X}]\nname=\"x\"\n", 0x2000 + i))),
    },
    Kind { name: "objects that are like a large one", files: like_a_large_one },
    Kind {
        name: "units that are like the next",
        files: |n| one(each(n, |i| format!("[units.u{i}]\nlike=\"u{}\"\n", i + 1))),
    },
    Kind {
        name: "units that are like each other",
        files: |n| one(each(n, |i| format!("[units.u{i}]\nlike=\"u{}\"\n", (i + 1) % n))),
    },
    Kind {
        name: "errors that are like none",
        files: |n| one(each(n, |i| format!("[errors.{i}]\nlike=\"x{i}\"\n"))),
    },
    Kind {
        name: "references to nothing",
        files: |n| {
            let wrong = list(n, |i| format!("\"gauge-numer-{i}\""));
            one(objects(n, |i| format!("name=\"Gauge number {i}\""))
                + &format!("[modes.8]\nobjects=[{wrong}]"))
        },
    },
    Kind {
        name: "units that there are not",
        files: |n| one(units(n) + &objects(n, |i| format!("name=\"N{i}\"\nunit=\"unti{i}\""))),
    },
    Kind {
        name: "units",
        files: |n| {
            one(units(n) + &objects(n, |i| format!("name=\"N{i}\"\nunit=\"unit{}\"", i % n.min(1_000))))
        },
    },
    Kind {
        name: "parts to leave out",
        files: |n| whole(format!("without=[{}]\n{HEAD}{}", parts(n), objects(n, |_| "name=\"x\"".into()))),
    },
    Kind {
        name: "parts to leave out that are not there",
        files: |n| whole(format!("without=[{}]\n{HEAD}", parts(n))),
    },
    Kind {
        name: "dots in a part to leave out",
        files: |n| whole(format!("without=[\"objects{}\"]\n{HEAD}", ".x".repeat(n))),
    },
    Kind {
        name: "areas",
        files: |n| {
            let areas = each(n, |i| format!("[areas.\"0x{i:04X}..=0xFFFF\"]\nname=\"A{i}\"\n"));
            one(areas + &objects(n, |i| format!("name=\"N{i}\"")))
        },
    },
    Kind { name: "PDOs", files: |n| one(pdos(n)) },
    Kind { name: "PDOs that exclude each other", files: exclusive_pdos },
    Kind {
        name: "entries of a PDO",
        files: |n| one(format!("[rx-pdos.0x1600]\nname=\"P\"\nentries=[{}]", "\"0x6040\",".repeat(n))),
    },
    Kind {
        name: "padding of a PDO",
        files: |n| one(format!("[rx-pdos.0x1600]\nname=\"P\"\nentries=[{}]", "{bits=8},".repeat(n))),
    },
    Kind { name: "entries of many PDOs", files: entries_of_many },
    Kind {
        name: "PDOs to assign",
        files: |n| one(pdos(n) + &assigned(&list(n, |i| format!("\"0x{:04X}\"", 0x1600 + i)))),
    },
    Kind { name: "a PDO to assign again", files: |n| one(pdos(1) + &assigned(&"\"0x1600\",".repeat(n))) },
    Kind {
        name: "sync managers",
        files: |n| one(each(n, |i| format!("[sync-managers.x{i}]\naddress=0x1100\n"))),
    },
    Kind {
        name: "configurations",
        files: |n| {
            let one_of =
                |i| format!("[configurations.c{i}]\nname=\"x\"\nmode={}\noutputs=[\"0x1600\"]\n", i % 100);
            one(pdos(1) + &each(n, one_of))
        },
    },
    Kind {
        name: "PDOs of a configuration",
        files: |n| {
            one(pdos(1) + &format!("[configurations.c]\nname=\"x\"\noutputs=[{}]", "\"0x1600\",".repeat(n)))
        },
    },
    Kind {
        name: "entries of a configuration",
        files: |n| {
            let entries = "\"0x6040\",".repeat(n);
            one(pdos(1) + &format!("[configurations.c]\nname=\"x\"\nmapping={{0x1600=[{entries}]}}"))
        },
    },
    Kind {
        name: "objects that a trigger uses",
        files: |n| {
            let uses = "\"0x6040\",".repeat(n);
            one(objects(1, |_| format!("trigger={{value=1,action=\"x\",uses=[{uses}]}}")))
        },
    },
    Kind {
        name: "what triggers change on many axes",
        files: |n| {
            let updates = list(0xE0, |i| format!("\"0x{:04X}\"", 0x2000 + i));
            let trigger = format!("trigger={{value=1,action=\"x\",updates=[{updates}]}}\n");
            let head =
                |i| format!("[objects.0x{:04X}]\nname=\"T{i}\"\ntype=\"UINT8\"\naccess=\"rw\"\n", 0x9000 + i);
            let triggers = each(n.div_ceil(0xE0), |i| head(i) + &trigger);
            one(axes(100) + &objects(0xE0, |i| format!("name=\"N{i}\"")) + &triggers)
        },
    },
];

fn family(members: String) -> Files {
    whole(format!("{HEAD}[family]\nname=\"F\"\n{members}"))
}

/// So many axes, each with its copy of 0x2000 to 0x20DF.
fn axes(count: usize) -> String {
    let names = list(count, |i| format!("\"a{i}\""));
    format!("[axes]\nnames=[{names}]\nshifts=[{{range=\"0x2000..=0x20DF\",by=0xE0}}]\n")
}

fn differing_axes(count: usize) -> Files {
    let axis = |i| format!("per-axis.a{i}.name=\"y\"\n");
    let values = list(count, |i| format!("{i}=\"v\""));
    one(axes(200) + &objects(1, |_| each(200, axis) + &format!("values={{{values}}}")))
}

fn units(count: usize) -> String {
    each(count.min(1_000), |i| format!("[units.unit{i}]\nquantity=\"p\"\nsymbol=\"x\"\n"))
}

fn parts(count: usize) -> String {
    list(count, |i| format!("\"objects.0x{:X}\"", 0x2000 + i))
}

fn pdos(count: usize) -> String {
    each(count, |i| format!("[rx-pdos.0x{:04X}]\nname=\"P{i}\"\nentries=[\"0x6040\"]\n", 0x1600 + i))
}

fn exclusive_pdos(count: usize) -> Files {
    let count = count.isqrt().min(500);
    let all = list(count, |i| format!("\"0x{:04X}\"", 0x1600 + i));
    let pdo = |i| {
        format!("[rx-pdos.0x{:04X}]\nname=\"P{i}\"\nentries=[\"0x6040\"]\nexcludes=[{all}]\n", 0x1600 + i)
    };
    one(each(count, pdo))
}

fn entries_of_many(count: usize) -> Files {
    let entries = "\"0x2000\",".repeat(40);
    let pdo = |i| format!("[rx-pdos.0x{:04X}]\nname=\"P{i}\"\nentries=[{{bits=1}},{entries}]\n", 0x1600 + i);
    one(objects(1, |_| "name=\"B\"\npdo=\"rx\"".into()) + &each((count / 20).min(500), pdo))
}

fn assigned(pdos: &str) -> String {
    format!("[sync-managers.outputs]\naddress=0x1100\npdos=[{pdos}]")
}

fn one_line(count: usize) -> Files {
    let object = |i| format!("0x{:04X}={{name=\"G\",type=\"UINT8\",access=\"rw\",max=300}}", 0x2000 + i);
    let device = "device={name=\"x\",vendor=\"v\"}\nidentity={vendor-id=1,product-code=2,revision=3}\n";
    whole(format!("{device}objects={{{}}}\n", list(count, object)))
}

fn like_a_large_one(count: usize) -> Files {
    let values = list(count.min(4_000), |i| format!("{i}=\"v{i}\""));
    let first = format!("[objects.0x2000]\nname=\"X\"\ntype=\"UINT32\"\nvalues={{{values}}}\n");
    let other = |i| format!("[objects.0x{:04X}]\nlike=\"0x2000\"\nid=\"x{i}\"\n", 0x2001 + i);
    one(first + &each(count.min(0xD000), other))
}
