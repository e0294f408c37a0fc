//! What kind of change a difference is: one file for each part of a device.
//!
//! What follows from another change is none of its own: mapping objects follow from the PDOs, the number of entries in
//! subindex 0 from the entries, the values of 0x1018 from the identity.

mod dictionary;
mod entry;
mod machine;
mod modes;
mod process_data;
mod timing;
mod transport;
mod units;
mod words;

use super::change::Kind;
use super::kinds;
use super::place::Versions;
use crate::model::{CheckedCode, CheckedRevision, Difference};
use crate::text::near::near;

/// What a difference is.
pub(super) struct Judged {
    pub(super) kind: &'static Kind,
    /// What it is a part of, if that is shown in its place.
    pub(super) of_whole: Option<Whole>,
}

/// Something that changes as a whole, whatever part of it differs.
pub(super) struct Whole {
    /// The steps of the path that lead to it.
    pub(super) depth: usize,
    pub(super) old: String,
    pub(super) new: String,
}

impl From<&'static Kind> for Judged {
    fn from(kind: &'static Kind) -> Self {
        Self { kind, of_whole: None }
    }
}

/// What kind of change a difference is; none if it is none of its own.
pub(super) fn judge(versions: Versions<'_>, path: &[&str], difference: &Difference) -> Option<Judged> {
    let kind = match path {
        _ if difference.is_order => order(path)?,
        ["identity", field] => identity(field, versions)?,
        ["objects", rest @ ..] => dictionary::judge(versions, rest, difference)?,
        ["pdos", rest @ ..] => return process_data::judge(versions, rest, difference),
        ["sync_managers", rest @ ..] => transport::sync_manager(versions, rest)?,
        ["mailbox", rest @ ..] => transport::mailbox(versions, rest, difference),
        ["eeprom", field] => transport::eeprom(field),
        ["configurations", rest @ ..] => return transport::configuration(rest, difference),
        ["sync_modes", rest @ ..] => timing::sync_mode(versions, rest, difference),
        ["cycle_times", rest @ ..] => timing::cycle_time(versions, rest, difference),
        ["dead_time", rest @ ..] => timing::dead_time(versions, rest, difference),
        ["timeouts", "source"] => &kinds::CHANGED_TEXT,
        ["timeouts", ..] => &kinds::CHANGED_TIMEOUT,
        ["ebus_current"] => transport::current(versions),
        ["no_lrw"] if versions.new.no_lrw => &kinds::SPLIT_COMMANDS,
        ["no_lrw"] => &kinds::JOINED_COMMANDS,
        ["diagnosis", rest @ ..] => words::message(rest, difference),
        ["words", _, rest @ ..] => words::word(rest, difference),
        ["states", rest @ ..] => machine::state(rest, difference),
        ["commands", rest @ ..] => machine::command(rest, difference),
        ["transitions", rest @ ..] => machine::transition(versions, rest, difference),
        ["device_control", ..] => &kinds::CHANGED_BEHAVIOUR,
        ["slots", _, "name" | "names" | "source", ..] => &kinds::CHANGED_TEXT,
        ["slots", ..] => &kinds::CHANGED_SLOTS,
        ["modules", _, "name" | "source"] => &kinds::CHANGED_TEXT,
        ["modules", ..] => &kinds::CHANGED_SLOTS,
        ["modes", rest @ ..] => modes::mode(versions, rest, difference)?,
        ["homing_methods", rest @ ..] => modes::homing_method(versions, rest, difference)?,
        ["errors" | "vendor_codes" | "al_status_codes" | "abort_codes", rest @ ..] => {
            words::error(rest, difference)?
        }
        ["units", rest @ ..] => units::unit(versions, rest, difference)?,
        _ => device(path)?,
    };
    Some(kind.into())
}

/// What a device says of itself, and what is for people.
fn device(path: &[&str]) -> Option<&'static Kind> {
    Some(match path {
        ["physics"] => &kinds::CHANGED_HARDWARE,
        ["profile"] => &kinds::CHANGED_PROFILE,
        ["axes", _, "name"] => &kinds::RENAMED,
        ["name" | "type_name"] => &kinds::RENAMED,
        // What members are called is how they are found; what repeats follows from the objects.
        ["id"] | ["repetitions", ..] => return None,
        [
            "names"
            | "vendor"
            | "url"
            | "urls"
            | "title"
            | "image"
            | "about"
            | "models"
            | "group"
            | "documents"
            | "axes"
            | "arrangement"
            | "areas"
            | "enumerations"
            | "communication_states"
            | "communication_transitions"
            | "mode_changes"
            | "stop_options"
            | "leds"
            | "connectors"
            | "parameters"
            | "coordinates"
            | "registers"
            | "telegrams"
            | "limits"
            | "master_settings"
            | "procedures"
            | "assumptions"
            | "remarks"
            | "errata"
            | "source",
            ..,
        ] => &kinds::CHANGED_TEXT,
        // A part of the model that is not judged yet is taken for what must not change.
        _ => &kinds::CHANGED_BEHAVIOUR,
    })
}

/// What another order of a list is.
fn order(path: &[&str]) -> Option<&'static Kind> {
    match path {
        ["slots"] => Some(&kinds::CHANGED_SLOTS),
        // The numbers of the first differ with it, the others follow the tables that they are about.
        ["sync_managers" | "assumptions"] => None,
        _ => Some(&kinds::REORDERED),
    }
}

fn identity(field: &str, versions: Versions<'_>) -> Option<&'static Kind> {
    let (old, new) = (versions.old.identity.revision, versions.new.identity.revision);
    Some(match field {
        "vendor_id" | "product_code" => &kinds::CHANGED_DEVICE,
        "revision" if new > old => &kinds::RAISED_REVISION,
        "revision" => &kinds::LOWERED_REVISION,
        "serial" => &kinds::CHANGED_LABEL,
        "check_product_code" | "check_revision" => accepted(field, versions),
        "requested_id" | "id_address" => set_number(versions),
        // Tools no longer offer the older ones; what is set up with them stays.
        _ => &kinds::CHANGED_TEXT,
    })
}

/// What a master that goes by the description accepts; nothing said is what it is set to.
fn accepted(field: &str, versions: Versions<'_>) -> &'static Kind {
    let accepts_any = match field {
        "check_product_code" => versions.new.identity.check_product_code == Some(CheckedCode::None),
        _ => versions.new.identity.check_revision == Some(CheckedRevision::None),
    };
    if accepts_any { &kinds::WIDENED_CHECK } else { &kinds::NARROWED_CHECK }
}

/// How a master finds the number that people set at the device.
fn set_number(versions: Versions<'_>) -> &'static Kind {
    let (old, new) = (&versions.old.identity, &versions.new.identity);
    let is_lost =
        old.requested_id && !new.requested_id || old.id_address.is_some() && old.id_address != new.id_address;
    if is_lost { &kinds::LOST_ID } else { &kinds::FOUND_ID }
}

/// Whether something is gone, has come, or is there in both versions.
enum Presence {
    Gone,
    Come,
    Both,
}

impl Presence {
    fn is_gone(&self) -> bool {
        matches!(self, Self::Gone)
    }
}

fn presence(difference: &Difference) -> Presence {
    match (&difference.first, &difference.second) {
        (Some(_), None) => Presence::Gone,
        (None, Some(_)) => Presence::Come,
        _ => Presence::Both,
    }
}

/// Whether another name means another thing, and is not only spelt otherwise.
fn means_else(difference: &Difference) -> bool {
    let (Some(old), Some(new)) = (&difference.first, &difference.second) else { return true };
    near(old, [new.as_str()].into_iter()).is_none()
}

/// Whether something does what it did.
fn function(difference: &Difference) -> &'static Kind {
    if difference.second.as_deref() == Some("true") { &kinds::GAINED_FUNCTION } else { &kinds::LOST_FUNCTION }
}

/// Whether a limit is less than before; none is no limit.
fn less<N: Ord>(old: Option<N>, new: Option<N>) -> bool {
    match (old, new) {
        (_, None) => false,
        (None, Some(_)) => true,
        (Some(old), Some(new)) => new < old,
    }
}
