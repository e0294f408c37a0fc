//! Faults that are provoked, and pulses that are given.

use std::str::FromStr;
use std::time::Duration;

use devc_virtual::drive::Drive;

/// A fault or a pulse as it is asked for: on an axis, maybe of a certain device, after a time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    pub(super) device: Option<String>,
    pub(super) axis: String,
    pub(super) code: u16,
    pub(super) after: Duration,
}

/// What is done to an axis at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Deed {
    /// A fault with the code.
    Fault,
    /// A pulse to the touch probe that has the code as its number, from 1.
    Pulse,
}

/// Something that is to come.
#[derive(Debug, Clone)]
pub(super) struct Due {
    pub(super) position: usize,
    pub(super) axis: usize,
    pub(super) deed: Deed,
    pub(super) code: u16,
    pub(super) after: Duration,
}

impl Due {
    /// Does it.
    pub(super) fn happen(&self, drive: &mut Drive) {
        match self.deed {
            Deed::Fault => drive.fault(self.axis, self.code),
            Deed::Pulse => {
                let probe = usize::from(self.code).saturating_sub(1);
                drive.signal(self.axis, probe, true);
                drive.signal(self.axis, probe, false);
            }
        }
    }
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (place, rest) = text.split_once('=').ok_or("expected `AXIS=CODE@TIME`, such as `X=0x7305@5s`")?;
        let (code, after) = rest.split_once('@').unwrap_or((rest, "0s"));
        let (device, axis) = match place.split_once('.') {
            Some((device, axis)) => (Some(device.to_owned()), axis),
            None => (None, place),
        };
        let code = match code.strip_prefix("0x") {
            Some(digits) => u16::from_str_radix(digits, 16),
            None => code.parse(),
        };
        let code = code.map_err(|_| "an error code is a number of 16 bits, such as `0x7305`")?;
        Ok(Self { device, axis: axis.to_owned(), code, after: time(after)? })
    }
}

/// A time such as `5s` or `200ms`.
pub(super) fn time(text: &str) -> Result<Duration, String> {
    let number = text.trim_end_matches(char::is_alphabetic);
    let factor = match text.get(number.len()..) {
        Some("s") => 1.0,
        Some("ms") => 1e-3,
        Some("min") => 60.0,
        _ => return Err("a time has a unit: `5s`, `200ms` or `2min`".to_owned()),
    };
    let number: f64 = number.parse().map_err(|_| format!("`{number}` is no number"))?;
    Duration::try_from_secs_f64(number * factor).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_read() {
        let fault = |device: Option<&str>, axis: &str, code, after| {
            let device = device.map(str::to_owned);
            Ok(Fault { device, axis: axis.to_owned(), code, after: Duration::from_millis(after) })
        };
        assert_eq!("X=0x7305@5s".parse(), fault(None, "X", 0x7305, 5000));
        assert_eq!("c887.W=12816@0.5s".parse(), fault(Some("c887"), "W", 12816, 500));
        assert_eq!("=0x8611".parse(), fault(None, "", 0x8611, 0));
        for wrong in ["X", "X=", "X=0x12345", "X=1@5", "X=1@-1s", "X=1@s", "X=-1@1s"] {
            assert!(wrong.parse::<Fault>().is_err(), "{wrong}");
        }
    }
}
