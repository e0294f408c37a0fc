//! What masters have stored in devices, in a file: so it is there when the devices run again.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use devc_runtime::object::Address;
use devc_virtual::drive::Stored;

use crate::draft::Draft;
use crate::existing;
use crate::outcome::Failure;
use crate::workplace::Workplace;

/// Values in hexadecimal by their addresses, by the place and the name of each device.
type Text = BTreeMap<String, BTreeMap<String, String>>;

/// The most bytes that are read of a file: more than all values of a long line of devices take.
const LARGEST: usize = 64 << 20;

/// A file with what devices have stored.
#[derive(Debug)]
pub(super) struct Store {
    path: PathBuf,
    kept: Text,
}

impl Store {
    /// Reads the file, if it is there.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        let Some(text) = existing::read(path, LARGEST)? else {
            return Ok(Self { path: path.to_owned(), kept: Text::new() });
        };
        let kept = serde_json::from_slice(&text).map_err(|error| {
            let what = format!("`{}` does not hold what devices have stored: {error}", path.display());
            Failure::new(what).help("`--store` takes a file of its own, which need not be there")
        })?;
        Ok(Self { path: path.to_owned(), kept })
    }

    /// What the device at a position has stored.
    pub(super) fn of(&self, position: usize, name: &str) -> Stored {
        let values = self.kept.get(&key(position, name)).into_iter().flatten();
        values.filter_map(|(address, value)| Some((address_of(address)?, bytes(value)?))).collect()
    }

    /// Writes what a device has stored now.
    pub(super) fn keep(&mut self, position: usize, name: &str, stored: &Stored) -> Result<(), Failure> {
        let hex = |value: &[u8]| value.iter().map(|byte| format!("{byte:02X}")).collect::<String>();
        let values = stored.iter().map(|(address, value)| (address.to_string(), hex(value)));
        self.kept.insert(key(position, name), values.collect());
        let text = serde_json::to_string_pretty(&self.kept).unwrap_or_default() + "\n";
        Draft::write(&Workplace::of(&self.path), &self.path, text)?.publish()
    }
}

fn key(position: usize, name: &str) -> String {
    format!("{position} {name}")
}

/// An address as it is printed: `0x2000:01`.
fn address_of(text: &str) -> Option<Address> {
    let (index, subindex) = text.strip_prefix("0x")?.split_once(':')?;
    Some(Address::new(u16::from_str_radix(index, 16).ok()?, u8::from_str_radix(subindex, 16).ok()?))
}

fn bytes(text: &str) -> Option<Vec<u8>> {
    let pairs = text.as_bytes().chunks(2);
    pairs.map(|pair| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok()).collect()
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn what_is_kept_is_there_again() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("stored.json");
        let values =
            Stored::from([(Address::new(0x2000, 0), vec![9, 0]), (Address::new(0x6065, 1), vec![0xFE])]);
        let mut store = Store::open(&path).expect("it need not be there");
        assert_eq!(store.of(1, "own"), Stored::new());
        store.keep(1, "own", &values).expect("it can be written");
        let mut store = Store::open(&path).expect("it is there");
        assert_eq!(store.of(1, "own"), values);
        assert_eq!((store.of(0, "own"), store.of(1, "other")), (Stored::new(), Stored::new()));
        store.keep(1, "own", &Stored::new()).expect("it can be written");
        assert_eq!(Store::open(&path).expect("it is there").of(1, "own"), Stored::new());
    }

    #[test]
    fn another_file_is_not_taken_for_one() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("device.toml");
        fs::write(&path, "[device]").expect("a file");
        let refused = Store::open(&path).expect_err("it is something else");
        assert!(refused.what.contains("does not hold what devices have stored"), "{refused:?}");
        assert_eq!(fs::read_to_string(&path).expect("it is there"), "[device]");
    }
}
