//! Bad input of every kind, and what devc says to it.

use std::io;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;

use super::*;
use crate::diagnostic::Diagnostics;
use crate::diagnostic::render::{Style, text};

const PROFILES: &[Profile] = &[
    Profile { name: "ethercat", text: "source = \"ETG.1000\"\n[objects.0x1000]\nname = \"Device type\"\n" },
    Profile { name: "cia402", text: "[objects.0x1000]\ntype = \"UINT32\"\n" },
];

/// What was read, and the messages as text.
fn read(loader: &dyn Loader, path: &str) -> (Option<Document>, String) {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let document = load(loader, Path::new(path), PROFILES, &mut sources, &mut diagnostics);
    let messages: Vec<String> = diagnostics.iter().map(|it| text(it, &sources, Style::Plain)).collect();
    (document, messages.join("\n\n"))
}

fn messages(loader: &dyn Loader) -> String {
    read(loader, "drive").1
}

fn good(loader: &dyn Loader) -> Document {
    let (document, messages) = read(loader, "drive");
    assert_eq!(messages, "");
    document.expect("a document")
}

fn find<'t>(table: &'t Table, path: &[&str]) -> &'t Member {
    let (first, rest) = path.split_first().expect("a path");
    let member = table.get(first).unwrap_or_else(|| panic!("no `{first}` in {table:?}"));
    if rest.is_empty() { member } else { find(member.node.table().expect("a table"), rest) }
}

#[test]
fn a_description_is_all_its_files() {
    let loader = Memory::new()
        .with(
            "drive/device.toml",
            "include = [\"a/objects.toml\"]\n[device]\nname = \"X\"\n[objects.0x2001]\n",
        )
        .with("drive/a/objects.toml", "include = [\"more.toml\"]\n[objects.0x2000]\n[[errata]]\nat = 1\n")
        .with("drive/a/more.toml", "[objects.0x2002]\n[[errata]]\nat = 2\n");
    let document = good(&loader);
    let objects = find(&document.root, &["objects"]).node.table().expect("objects");
    let names: Vec<&str> = objects.members.iter().map(|member| &*member.key.name).collect();
    assert_eq!(names, ["0x2001", "0x2000", "0x2002"]);
    let Value::Array(errata) = &find(&document.root, &["errata"]).node.value else { panic!("an array") };
    assert_eq!(errata.len(), 2);
    assert!(document.root.get("include").is_none());
    assert_eq!(
        document.files,
        ["drive/device.toml", "drive/a/objects.toml", "drive/a/more.toml"].map(PathBuf::from)
    );
}

#[test]
fn a_file_that_two_others_include_is_read_once() {
    let loader = Memory::new()
        .with("drive/device.toml", "include = [\"a.toml\", \"b.toml\"]")
        .with("drive/a.toml", "include = [\"c.toml\"]")
        .with("drive/b.toml", "include = [\"c.toml\"]")
        .with("drive/c.toml", "[objects.0x2000]");
    assert_eq!(good(&loader).files.len(), 4);
}

#[test]
fn later_profiles_lie_over_earlier_ones() {
    let loader = Memory::new().with("drive/device.toml", "profiles = [\"ethercat\", \"cia402\"]");
    let document = good(&loader);
    assert_eq!(find(&document.profile, &["objects", "0x1000", "name"]).node.at.file, FileId(1));
    assert_eq!(find(&document.profile, &["objects", "0x1000", "type"]).node.at.file, FileId(2));
    assert_eq!(document.files.len(), 1);
}

#[test]
fn the_source_of_a_file_is_the_source_of_what_is_in_it() {
    let loader = Memory::new().with(
        "drive/device.toml",
        "source = \"p. 1\"\n[device]\nname = \"X\"\n[objects]\n1 = {}\n2 = { source = \"p. 2\" }\n[[errata]]\nat = 1\n",
    );
    let document = good(&loader);
    let source = |path: &[&str]| find(&document.root, path).node.value.clone();
    assert_eq!(source(&["objects", "1", "source"]), Value::String("p. 1".into()));
    assert_eq!(source(&["objects", "2", "source"]), Value::String("p. 2".into()));
    assert_eq!(find(&document.root, &["objects", "1", "source"]).key.at.start, 0);
    assert!(find(&document.root, &["device"]).node.table().expect("a table").get("source").is_none());
}

#[test]
fn every_syntax_error_of_every_file_is_reported() {
    let loader = Memory::new()
        .with("drive/device.toml", "include = [\"objects.toml\"]\n[device]\nname = \"X\nsize =\n")
        .with("drive/objects.toml", "[objects.0x2000]\nname = \"Speed\"\n[objects.0x2001]\nmax = 0x");
    assert_snapshot!(messages(&loader), @r#"
    error[invalid-toml]: this is not TOML: a string does not end
     --> drive/device.toml:3:10
      |
    3 | name = "X
      |          ^ expected `"`

    error[invalid-toml]: this is not TOML: a value is missing
     --> drive/device.toml:4:7
      |
    4 | size =
      |       ^

    error[invalid-toml]: `0x` is not an integer
     --> drive/objects.toml:4:7
      |
    4 | max = 0x
      |       ^^ expected digits
    "#);
}

#[test]
fn a_key_that_is_defined_twice_shows_both_places() {
    let text = "[[a]]\nx = 1\n[[a]]\nx = 1\nx = 2\n[b.c]\n[b.d]\n[b.c]\n[e]\nf = { g = 1, g = 2 }\nh.i = 1\nh.i = 2\n";
    assert_snapshot!(messages(&Memory::new().with("drive/device.toml", text)), @r"
    error[invalid-toml]: `x` is defined twice
     --> drive/device.toml:5:1
      |
    4 | x = 1
      | - first defined here
    5 | x = 2
      | ^ defined again here

    error[invalid-toml]: `c` is defined twice
     --> drive/device.toml:8:4
      |
    6 | [b.c]
      |    - first defined here
    7 | [b.d]
    8 | [b.c]
      |    ^ defined again here

    error[invalid-toml]: `g` is defined twice
      --> drive/device.toml:10:14
       |
    10 | f = { g = 1, g = 2 }
       |       -      ^ defined again here
       |       |
       |       first defined here

    error[invalid-toml]: `i` is defined twice
      --> drive/device.toml:12:3
       |
    11 | h.i = 1
       |   - first defined here
    12 | h.i = 2
       |   ^ defined again here
    ");
}

#[test]
fn integers_have_any_radix_and_a_limit() {
    let loader = Memory::new().with(
        "drive/device.toml",
        "a = 0xFFFF_FFFF_FFFF_FFFF\nb = -0\nc = 0b101\nd = 0o17\ne = 0x1_00000000_00000000_00000000_00000000\nf = 1e999\n",
    );
    let (document, messages) = read(&loader, "drive");
    let root = document.expect("a document").root;
    let value = |name| find(&root, &[name]).node.value.clone();
    assert_eq!(["a", "b", "c", "d"].map(value), [i128::from(u64::MAX), 0, 5, 15].map(Value::Integer));
    assert_snapshot!(messages, @r"
    error[invalid-toml]: the integer 0x100000000000000000000000000000000 is too large
     --> drive/device.toml:5:5
      |
    5 | e = 0x1_00000000_00000000_00000000_00000000
      |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ does not fit 128 bits

    error[invalid-toml]: the float 1e999 is too large
     --> drive/device.toml:6:5
      |
    6 | f = 1e999
      |     ^^^^^ does not fit 64 bits
    ");
}

#[test]
fn tables_stand_at_their_headers() {
    let text = "[objects.0x6040]\nunit = { name = 1 }\n[objects.0x6041]\na.b = 1\n";
    let root = good(&Memory::new().with("drive/device.toml", text)).root;
    let at = |path: &[&str]| {
        let at = find(&root, path).node.at;
        &text[at.start as usize..at.end as usize]
    };
    assert_eq!(at(&["objects"]), "objects");
    assert_eq!(at(&["objects", "0x6040"]), "[objects.0x6040]");
    assert_eq!(at(&["objects", "0x6040", "unit"]), "{ name = 1 }");
    assert_eq!(at(&["objects", "0x6041", "a"]), "a");
}

#[test]
fn no_description() {
    let loader = Memory::new().with("drive/devise.toml", "").with("other.toml", "");
    assert_snapshot!(read(&loader, "drive").1, @r"
    error[missing-file]: `drive` holds no description
     |
     = note: a description is a folder with a `device.toml`, or a TOML file
     = help: give a folder that has a `device.toml`, or name the file
    ");
    assert_snapshot!(read(&loader, "driv").1, @r"
    error[missing-file]: `driv` does not exist
     |
     = help: `drive` lies beside it
    ");
    assert_snapshot!(read(&loader, "drive/device.toml").1, @r"
    error[missing-file]: `drive/device.toml` does not exist
     |
     = help: `devise.toml` lies beside it
    ");
}

#[test]
fn a_missing_include_names_one_that_is_there() {
    let loader = Memory::new()
        .with("drive/device.toml", "include = [\"parts/object.toml\", \"modes.toml\"]")
        .with("drive/parts/objects.toml", "");
    assert_snapshot!(messages(&loader), @r#"
    error[missing-file]: `drive/parts/object.toml` does not exist
     --> drive/device.toml:1:12
      |
    1 | include = ["parts/object.toml", "modes.toml"]
      |            ^^^^^^^^^^^^^^^^^^^ included here
      |
    help: did you mean `objects.toml`?
      |
    1 | include = ["parts/objects.toml", "modes.toml"]
      |                         +

    error[missing-file]: `drive/modes.toml` does not exist
     --> drive/device.toml:1:33
      |
    1 | include = ["parts/object.toml", "modes.toml"]
      |                                 ^^^^^^^^^^^^ included here
      |
      = note: an include is relative to the file that names it
    "#);
}

#[test]
fn files_that_include_one_another() {
    let loader = Memory::new()
        .with("drive/device.toml", "include = [\"a.toml\"]")
        .with("drive/a.toml", "include = [\"b.toml\", \"a.toml\"]")
        .with("drive/b.toml", "include = [\"./a.toml\"]");
    assert_snapshot!(messages(&loader), @r#"
    error[include-cycle]: `drive/a.toml` includes itself
     --> drive/b.toml:1:12
      |
    1 | include = ["./a.toml"]
      |            ^^^^^^^^^^ `./a.toml` is being read already
      |
      = note: the includes are drive/a.toml -> drive/b.toml -> drive/a.toml
      = help: remove one of them

    error[include-cycle]: `drive/a.toml` includes itself
     --> drive/a.toml:1:22
      |
    1 | include = ["b.toml", "a.toml"]
      |                      ^^^^^^^^
      |
      = note: the includes are drive/a.toml -> drive/a.toml
      = help: remove one of them
    "#);
}

#[test]
fn a_long_chain_of_includes_is_cut() {
    let loader = (0..100)
        .fold(Memory::new().with("drive/device.toml", "include = [\"0.toml\"]"), |loader, n| {
            loader.with(format!("drive/{n}.toml"), format!("include = [\"{}.toml\"]", n + 1))
        });
    assert_snapshot!(messages(&loader), @r#"
    error[include-cycle]: more than 64 files include one another in a row
     --> drive/62.toml:1:12
      |
    1 | include = ["63.toml"]
      |            ^^^^^^^^^ not read
    "#);
}

#[test]
fn an_include_outside_the_folder() {
    let loader = Memory::new()
        .with("drive/device.toml", "include = [\"../secret.toml\", \"/secret.toml\"]")
        .with("secret.toml", "[objects.0x2000]")
        .with("/secret.toml", "[objects.0x2000]");
    let (document, messages) = read(&loader, "drive");
    assert!(document.expect("a document").root.members.is_empty());
    assert_snapshot!(messages, @r#"
    error[outside-include]: `../secret.toml` lies outside the folder of the description
     --> drive/device.toml:1:12
      |
    1 | include = ["../secret.toml", "/secret.toml"]
      |            ^^^^^^^^^^^^^^^^ leaves the folder
      |
      = note: a description is one folder that can be moved as a whole; links are followed
      = help: copy the file into the folder of the description

    error[outside-include]: `/secret.toml` lies outside the folder of the description
     --> drive/device.toml:1:30
      |
    1 | include = ["../secret.toml", "/secret.toml"]
      |                              ^^^^^^^^^^^^^^ leaves the folder
      |
      = note: a description is one folder that can be moved as a whole; links are followed
      = help: copy the file into the folder of the description
    "#);
}

#[cfg(unix)]
#[test]
fn a_link_out_of_the_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let drive = folder.path().join("drive");
    std::fs::create_dir(&drive).expect("a folder");
    std::fs::write(drive.join("device.toml"), "include = [\"here.toml\", \"link.toml\"]").expect("a file");
    std::fs::write(drive.join("here.toml"), "[objects.0x2000]").expect("a file");
    std::fs::write(folder.path().join("secret.toml"), "[objects.0x2001]").expect("a file");
    std::os::unix::fs::symlink("../secret.toml", drive.join("link.toml")).expect("a link");
    let (document, messages) = read(&Disk, drive.to_str().expect("a path"));
    assert_eq!(document.expect("a document").files, [drive.join("device.toml"), drive.join("here.toml")]);
    assert!(messages.starts_with("error[outside-include]: `link.toml` lies outside"), "{messages}");
}

#[test]
fn bytes_that_are_no_text() {
    let loader = Memory::new()
        .with("drive/device.toml", "include = [\"latin1.toml\", \"folder\"]")
        .with("drive/latin1.toml", b"a = 1\nb = \"\xE4\"\n".to_vec())
        .with("drive/folder/objects.toml", "");
    assert_snapshot!(messages(&loader), @r#"
    error[unreadable-file]: `drive/latin1.toml` is not UTF-8 at byte 11, in line 2
     --> drive/device.toml:1:12
      |
    1 | include = ["latin1.toml", "folder"]
      |            ^^^^^^^^^^^^^ included here
      |
      = help: save the file as UTF-8

    error[unreadable-file]: `drive/folder` is a folder, not a file
     --> drive/device.toml:1:27
      |
    1 | include = ["latin1.toml", "folder"]
      |                           ^^^^^^^^ included here
    "#);
    let main = Memory::new().with("drive/device.toml", b"\xFF\xFE".to_vec());
    assert_snapshot!(messages(&main), @r"
    error[unreadable-file]: `drive/device.toml` is not UTF-8 at byte 0, in line 1
     |
     = help: save the file as UTF-8
    ");
}

#[test]
fn a_file_without_end() {
    let loader = Memory::new().with("drive/device.toml", vec![b' '; MAX_SIZE + 10]);
    assert_snapshot!(messages(&loader), @"error[unreadable-file]: `drive/device.toml` is larger than 64 MiB");
}

/// A file system in which one file may not be opened.
struct Locked(Memory, &'static str);

impl Loader for Locked {
    fn read(&self, path: &Path) -> io::Result<Opened> {
        if path.ends_with(self.1) { Err(io::ErrorKind::PermissionDenied.into()) } else { self.0.read(path) }
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        self.0.canonical(path)
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<String>> {
        self.0.list(folder)
    }
}

#[test]
fn a_file_that_may_not_be_opened() {
    let files = Memory::new().with("drive/device.toml", "include = [\"a.toml\"]").with("drive/a.toml", "");
    assert_snapshot!(messages(&Locked(files.clone(), "a.toml")), @r#"
    error[unreadable-file]: `drive/a.toml` cannot be read: permission denied
     --> drive/device.toml:1:12
      |
    1 | include = ["a.toml"]
      |            ^^^^^^^^ included here
    "#);
    assert_snapshot!(messages(&Locked(files, "device.toml")), @"error[unreadable-file]: `drive/device.toml` cannot be read: permission denied");
}

#[test]
fn an_unknown_profile() {
    let loader = Memory::new().with("drive/device.toml", "profiles = [\"cia-402\", \"drive\"]");
    assert_snapshot!(messages(&loader), @r#"
    error[unknown-profile]: there is no profile `cia-402`
     --> drive/device.toml:1:13
      |
    1 | profiles = ["cia-402", "drive"]
      |             ^^^^^^^^^ devc has `ethercat` and `cia402`
      |
    help: did you mean `cia402`?
      |
    1 - profiles = ["cia-402", "drive"]
    1 + profiles = ["cia402", "drive"]
      |

    error[unknown-profile]: there is no profile `drive`
     --> drive/device.toml:1:24
      |
    1 | profiles = ["cia-402", "drive"]
      |                        ^^^^^^^ devc has `ethercat` and `cia402`
    "#);
}

#[test]
fn settings_of_the_wrong_type() {
    let loader = Memory::new().with("drive/device.toml", "include = \"a.toml\"\nprofiles = [402]");
    assert_snapshot!(messages(&loader), @r#"
    error[wrong-type]: `include` has to be a list of strings
     --> drive/device.toml:1:11
      |
    1 | include = "a.toml"
      |           ^^^^^^^^ expected an array, found a string

    error[wrong-type]: `profiles` has to be a list of strings
     --> drive/device.toml:2:13
      |
    2 | profiles = [402]
      |             ^^^ expected a string, found an integer
    "#);
}

#[test]
fn one_entity_in_two_files() {
    let loader = Memory::new()
        .with("drive/device.toml", "include = [\"a.toml\"]\nkind = 1\n[objects.0x2000]\nname = \"Speed\"\n")
        .with("drive/a.toml", "kind = 2\n[objects.0x2001]\n[objects.0x2000]\nname = \"Velocity\"\n");
    assert_snapshot!(messages(&loader), @r"
    error[duplicate-definition]: `kind` is defined in two files
     --> drive/a.toml:1:1
      |
    1 | kind = 2
      | ^^^^ defined again here
      |
     ::: drive/device.toml:2:1
      |
    2 | kind = 1
      | ---- first defined here
      |
      = help: keep one of the two, with what both say

    error[duplicate-definition]: `0x2000` is defined in two files
     --> drive/a.toml:3:10
      |
    3 | [objects.0x2000]
      |          ^^^^^^ defined again here
      |
     ::: drive/device.toml:3:10
      |
    3 | [objects.0x2000]
      |          ------ first defined here
      |
      = help: keep one of the two, with what both say
    ");
}
