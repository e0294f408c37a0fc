//! What the things of a section are called.

/// Sections whose key does not say how one of its things is called.
const NOUNS: &[(&str, &str)] = &[
    ("abort-codes", "SDO abort code"),
    ("al-status-codes", "AL status code"),
    ("leds", "LED"),
    ("rx-pdos", "RxPDO"),
    ("tx-pdos", "TxPDO"),
];

/// One of the things of a section: `object` for `objects`.
pub(super) fn noun(section: &str) -> String {
    let known = NOUNS.iter().find(|(key, _)| *key == section);
    known.map_or_else(|| section.trim_end_matches('s').replace('-', " "), |(_, noun)| (*noun).to_owned())
}
