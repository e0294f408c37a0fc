//! `check --fix` edits the file that was read, and loses nothing of it.

use crate::{Desk, SOUND};

/// A description in which one name is misspelled, which a fix mends.
fn misspelled() -> String {
    SOUND.replace("access = ", "acess  = ")
}

/// The same, with its name spelled right.
fn mended() -> String {
    misspelled().replace("acess", "access")
}

#[test]
fn one_that_cannot_be_edited_does_not_stop_the_others() {
    let desk = Desk::new(&[("a", &misspelled()), ("b", &misspelled())]);
    let path = desk.path("devices/a/device.toml");
    let mut rights = std::fs::metadata(&path).expect("a file").permissions();
    rights.set_readonly(true);
    std::fs::set_permissions(&path, rights).expect("a mode");
    desk.devc(&["check", "--fix"])
        .ends(2, &["it is read-only", "make it writable", "devices/b: made 1 edit"]);
    assert_eq!(desk.read("devices/a/device.toml"), misspelled());
    assert_eq!(desk.read("devices/b/device.toml"), mended());
}

#[cfg(unix)]
mod unix {
    use std::ffi::OsStr;
    use std::fs::{self, File};
    use std::io::{BufRead, BufReader};
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::fs::{MetadataExt, chown};
    use std::path::Path;
    use std::process::Stdio;

    use super::{mended, misspelled};
    use crate::unix::is_superuser;
    use crate::{Desk, Run, SOUND};

    /// Beside what is read lies a file that is shown in the same way.
    #[test]
    fn what_is_shown_may_stand_for_another() {
        for (given, read, other) in [
            ("a\\b", "a\\b/device.toml", "a/b/device.toml"),
            ("link/../x", "real/x/device.toml", "x/device.toml"),
        ] {
            let desk = Desk::new(&[]);
            desk.put("real/y/device.toml", SOUND);
            desk.link("real/y", "link");
            desk.put(read, misspelled());
            desk.put(other, misspelled());
            desk.devc(&["check", "--fix", given]).ends(0, &["made 1 edit"]);
            assert_eq!((desk.read(read), desk.read(other)), (mended(), misspelled()), "{given}");
        }
    }

    /// Programs make the edits by the path that they are told.
    #[test]
    fn what_is_shown_to_programs_leads_to_the_file() {
        for (given, shown) in [
            ("a\\b", "a\\\\b/device.toml"),
            ("link/../x", "link/../x/device.toml"),
            ("./a/../x", "x/device.toml"),
        ] {
            let desk = Desk::new(&[]);
            desk.put("real/y/device.toml", SOUND);
            desk.put("a/device.toml", SOUND);
            desk.link("real/y", "link");
            for path in ["a\\b", "real/x", "x"] {
                desk.put(&format!("{path}/device.toml"), misspelled());
            }
            desk.devc(&["check", "--format", "json", given]).ends(1, &[&format!("\"file\": \"{shown}\"")]);
        }
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_name_that_is_no_text() {
        let desk = Desk::new(&[]);
        for name in [&b"x\xFF"[..], b"x\xFE", "x\u{FFFD}".as_bytes()] {
            let folder = desk.path("devices").join(OsStr::from_bytes(name));
            fs::create_dir_all(&folder).expect("a folder");
            fs::write(folder.join("device.toml"), misspelled()).expect("a file");
        }
        let text = |name: &[u8]| {
            fs::read_to_string(desk.path("devices").join(OsStr::from_bytes(name)).join("device.toml"))
                .expect("a text")
        };
        let path = Path::new("devices").join(OsStr::from_bytes(b"x\xFF"));
        desk.finish(desk.command(&["check", "--fix"]).arg(path)).ends(0, &["made 1 edit"]);
        assert_eq!(text(b"x\xFF"), mended());
        assert_eq!((text(b"x\xFE"), text("x\u{FFFD}".as_bytes())), (misspelled(), misspelled()));
    }

    #[test]
    fn a_link_stays_one() {
        let desk = Desk::new(&[("drive", "include = [\"part.toml\"]\n")]);
        desk.put("devices/drive/parts/real.toml", misspelled());
        desk.link("parts/real.toml", "devices/drive/part.toml");
        desk.devc(&["check", "--fix"]).ends(0, &["made 1 edit"]);
        assert_eq!(desk.read("devices/drive/parts/real.toml"), mended());
        assert!(
            fs::symlink_metadata(desk.path("devices/drive/part.toml")).is_ok_and(|data| data.is_symlink())
        );
    }

    #[test]
    fn mode_and_owner_stay() {
        let desk = Desk::new(&[("drive", &misspelled())]);
        let path = desk.path("devices/drive/device.toml");
        desk.set_mode("devices/drive/device.toml", 0o606);
        if is_superuser() {
            chown(&path, Some(1234), Some(4321)).expect("an owner");
        }
        let facts = || fs::metadata(&path).map(|data| (data.mode(), data.uid(), data.gid())).expect("a file");
        let before = facts();
        desk.devc(&["check", "--fix"]).ends(0, &["made 1 edit"]);
        assert_eq!(facts(), before);
    }

    #[test]
    fn the_file_of_another_user_stays_theirs() {
        let desk = Desk::new(&[("drive", &misspelled())]);
        if !is_superuser() {
            return crate::unix::skipped("only the superuser can give a file away");
        }
        let Some(run) = desk.as_nobody(&["check"]) else {
            return crate::unix::skipped("nobody cannot run devc");
        };
        run.ends(1, &["acess"]);
        chown(desk.path("devices/drive/device.toml"), Some(0), Some(0)).expect("an owner");
        desk.set_mode("devices/drive/device.toml", 0o666);
        let mut command = desk.command(&["check", "--fix"]);
        std::os::unix::process::CommandExt::uid(&mut command, 65534);
        desk.finish(&mut command).ends(2, &["it belongs to another", "as its owner"]);
        assert_eq!(desk.list("devices/drive"), ["device.toml"]);
        assert_eq!(desk.read("devices/drive/device.toml"), misspelled());
    }

    #[test]
    fn a_folder_that_cannot_be_written_to() {
        let desk = Desk::new(&[("drive", &misspelled())]);
        desk.set_mode("devices/drive", 0o555);
        match desk.as_nobody(&["check", "--fix"]) {
            Some(run) => _ = run.ends(2, &["cannot write `", "device.toml`: permission denied"]),
            None => crate::unix::skipped("the superuser may write anywhere"),
        }
        assert_eq!(desk.list("devices/drive"), ["device.toml"]);
        assert_eq!(desk.read("devices/drive/device.toml"), misspelled());
        desk.set_mode("devices/drive", 0o755);
    }

    /// The later one sees that the file is another by now; which text it saw, and so how it ends, is a matter of time.
    #[test]
    fn several_at_once_make_an_edit_once() {
        for _ in 0..8 {
            let desk = Desk::new(&[("drive", &misspelled())]);
            let start = |_| {
                let mut command = desk.command(&["check", "--fix"]);
                command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("devc")
            };
            let runs: Vec<_> = (0..4).map(start).collect();
            let runs: Vec<Run> = runs.into_iter().map(Run::of).collect();
            let made = runs.iter().filter(|run| run.err.contains("made 1 edit")).count();
            assert_eq!(made, 1);
            for run in runs.iter().filter(|run| run.code != Some(0)) {
                run.ends(2, &["was changed while devc looked at it", "run devc again"]);
            }
            assert_eq!(desk.read("devices/drive/device.toml"), mended());
            assert_eq!(desk.list("devices/drive"), ["device.toml"]);
        }
    }

    #[test]
    fn a_file_with_another_name_is_not_split() {
        let desk = Desk::new(&[("drive", &misspelled())]);
        fs::hard_link(desk.path("devices/drive/device.toml"), desk.path("other.toml")).expect("a link");
        desk.devc(&["check", "--fix"]).ends(2, &["by a hard link", "copy it"]);
        assert_eq!(
            (desk.read("devices/drive/device.toml"), desk.read("other.toml")),
            (misspelled(), misspelled())
        );
        assert_eq!(desk.list("devices/drive"), ["device.toml"]);
    }

    /// While devc waits for the folder, the user saves; as editors do, over the file or as a new one in its place.
    #[test]
    fn what_is_saved_meanwhile_is_kept() {
        let saved = format!("# mine\n{}", misspelled());
        for by_renaming in [false, true] {
            let desk = Desk::new(&[("drive", &misspelled())]);
            let folder = File::open(desk.path("devices/drive")).expect("a folder");
            folder.lock().expect("a lock");
            let mut child = desk
                .command(&["check", "--fix"])
                .stderr(Stdio::piped())
                .stdout(Stdio::null())
                .spawn()
                .expect("devc");
            let mut said = BufReader::new(child.stderr.take().expect("a pipe")).lines();
            let line = said.next().expect("a line").expect("a line");
            assert!(line.starts_with("waiting for another devc that writes to"), "{line}");
            if by_renaming {
                desk.put("devices/drive/new", &saved);
                fs::rename(desk.path("devices/drive/new"), desk.path("devices/drive/device.toml"))
                    .expect("a name");
            } else {
                desk.put("devices/drive/device.toml", &saved);
            }
            drop(folder);
            let rest: Vec<String> = said.map(|line| line.expect("a line")).collect();
            assert!(rest.iter().any(|line| line.contains("was changed while devc looked at it")), "{rest:?}");
            assert_eq!(child.wait().expect("an end").code(), Some(2));
            assert_eq!(desk.read("devices/drive/device.toml"), saved);
            assert_eq!(desk.list("devices/drive"), ["device.toml"]);
        }
    }

    /// A disk that is full in the middle of a file, as a limit on the size of files plays it.
    #[test]
    #[cfg(target_os = "linux")]
    fn a_full_disk_leaves_what_was_there() {
        let text = format!("{}{}", misspelled(), "# more\n".repeat(1000));
        let desk = Desk::new(&[("drive", &text)]);
        desk.shell("trap '' XFSZ; ulimit -f 1; exec \"$1\" check --fix")
            .ends(2, &["device.toml`: file too large"]);
        assert_eq!(desk.read("devices/drive/device.toml"), text);
        assert_eq!(desk.list("devices/drive"), ["device.toml"]);
    }

    /// An editor cannot tell a draft from a file of the user's; the next run that edits clears it away.
    #[test]
    fn what_a_killed_run_left_goes() {
        let desk = Desk::new(&[("drive", &misspelled())]);
        desk.put("devices/drive/.devc-draft-1-0", "half");
        desk.put("devices/drive/.devc-draft-folder/mine", "");
        desk.devc(&["check", "--fix"]).ends(0, &["made 1 edit"]);
        assert_eq!(desk.list("devices/drive"), [".devc-draft-folder", "device.toml"]);
    }
}
