//! The standard profiles that devc brings along.

#[cfg(any(feature = "cli", feature = "wireshark"))]
use crate::diagnostic::Diagnostics;
use crate::source::Profile;
#[cfg(any(feature = "cli", feature = "wireshark"))]
use crate::source::{Sources, Table, read_profile};

/// What `profiles = [..]` can name.
pub(crate) const ALL: &[Profile] = &[
    Profile { name: "ethercat", text: include_str!("../profiles/ethercat.toml") },
    Profile { name: "cia402", text: include_str!("../profiles/cia402.toml") },
];

/// A profile as a tree.
#[cfg(any(feature = "cli", feature = "wireshark"))]
pub(crate) fn tree(name: &str) -> Option<Table> {
    let profile = ALL.iter().find(|profile| profile.name == name)?;
    Some(read_profile(profile, &mut Sources::default(), &mut Diagnostics::default()))
}

#[cfg(test)]
mod tests {
    use super::ALL;

    /// The numbers that keys of a profile have behind `start`.
    fn codes(profile: &str, start: &str) -> Vec<u16> {
        let text = ALL.iter().find(|it| it.name == profile).map(|it| it.text).unwrap();
        let digits = |line: &'static str| {
            line.strip_prefix(start)?.trim_start_matches('"').strip_prefix("0x")?.get(..4)
        };
        let numbers = text.lines().filter_map(|line| u16::from_str_radix(digits(line)?, 16).ok());
        numbers.collect()
    }

    fn missing(known: &[u16], expected: &str) -> Vec<String> {
        let expected = expected.split_whitespace().map(|code| u16::from_str_radix(code, 16).unwrap());
        expected.filter(|code| !known.contains(code)).map(|code| format!("{code:04X}")).collect()
    }

    /// IEC 61800-7-201, the table of error codes.
    #[test]
    fn all_error_codes_of_cia_402_are_known() {
        const CODES: &str = "
            0000 1000 2000 2100 2110 2120 2121 2122 2123 2130 2131 2132 2133 2200 2211 2212 2213 2214 2220 2221 2222
            2230 2240 2250 2300 2310 2311 2312 2320 2330 2331 2332 2333 2340 2341 2342 2343 2350 2351 3000 3100 3110
            3111 3112 3113 3120 3121 3122 3123 3130 3131 3132 3133 3134 3140 3141 3142 3200 3210 3211 3212 3220 3221
            3222 3230 3300 3310 3311 3312 3313 3320 3321 3330 3331 4000 4100 4110 4120 4130 4140 4200 4210 4220 4300
            4310 4320 4400 4410 4420 5000 5100 5110 5111 5112 5113 5114 5115 5116 5117 5118 5119 5120 5200 5210 5220
            5300 5400 5410 5420 5430 5440 5441 5442 5443 5444 5445 5450 5451 5452 5453 5454 5455 5456 5457 5458 5459
            5500 5510 5520 5530 6000 6010 6100 6200 6300 6301 6310 6320 7000 7100 7110 7111 7112 7113 7120 7121 7122
            7123 7200 7300 7301 7302 7303 7304 7305 7306 7307 7310 7320 7400 7500 7510 7520 7600 8000 8100 8200 8300
            8311 8312 8313 8321 8331 8400 8500 8600 8611 8612 8700 8800 8900 8A00 9000 F000 F001 F002 F003 F004 FF00";
        assert_eq!(missing(&codes("cia402", "[errors."), CODES), [""; 0]);
    }

    /// ETG.1000.6 and ETG.1020, the tables of AL status codes.
    #[test]
    fn all_al_status_codes_are_known() {
        const CODES: &str = "
            0000 0001 0002 0003 0004 0006 0007 000E 0011 0012 0013 0014 0015 0016 0017 0018 0019 001A 001B 001C 001D
            001E 001F 0020 0021 0022 0023 0024 0025 0026 0027 0028 0029 002A 002B 002C 002D 0030 0031 0032 0033 0034
            0035 0036 0037 0041 0042 0043 0044 0045 004F 0050 0051 0052 0060 0061 0070 0080 0081 0082 0083 00F0";
        assert_eq!(missing(&codes("ethercat", ""), CODES), [""; 0]);
    }
}
