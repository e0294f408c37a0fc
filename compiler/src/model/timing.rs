//! Time.

use devc_start_up::{CycleLimit, Interface, MappedPdo};

use super::table::{part, table};
use super::{Configuration, Delay, Device, Direction, Duration, ModeManagers, Role};

table! {
    /// `[sync-modes.<id>]`: a way to keep time with the master.
    pub struct SyncMode by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// The value of the register that starts the distributed clocks; 0 for none.
        pub assign_activate: u16,
        /// Whether a master should take it if nothing is said.
        #[serde(default)]
        pub default: bool,
        /// The first signal.
        pub sync0: Option<SyncSignal>,
        /// The second signal.
        pub sync1: Option<SyncSignal>,
        /// What sync managers do in it other than by default, by their keys in `[sync-managers]`.
        #[serde(default)]
        pub managers: ModeManagers,
        /// What else is to be said.
        pub about: Option<String>,
    }

    /// `[cycle-times.<id>]`: how often set values may come.
    pub struct CycleTime by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// What the limit holds for.
        pub name: String,
        /// The shortest cycle.
        #[serde(rename(serialize = "min_ns"))]
        pub min: Option<Duration>,
        /// The cycles that can be chosen, if only some.
        #[serde(default, rename(serialize = "choices_ns"))]
        pub choices: Vec<Duration>,
        /// The modes of operation that the limit holds for; all that have no limit of their own if absent.
        #[serde(default)]
        pub modes: Vec<i16>,
        /// What else is to be said.
        pub about: Option<String>,
    }

    /// `[timeouts]`: how long a master waits for the device, for a change of the EtherCAT state and for mail.
    pub struct Timeouts {
        /// For Pre-Operational.
        #[serde(rename(serialize = "pre_op_ns"))]
        pub pre_op: Option<Duration>,
        /// For Safe-Operational and Operational.
        #[serde(rename(serialize = "safe_op_op_ns"))]
        pub safe_op_op: Option<Duration>,
        /// For Init, on the way back.
        #[serde(rename(serialize = "back_to_init_ns"))]
        pub back_to_init: Option<Duration>,
        /// For Safe-Operational, on the way back.
        #[serde(rename(serialize = "back_to_safe_op_ns"))]
        pub back_to_safe_op: Option<Duration>,
        /// Until the device has read a request.
        #[serde(rename(serialize = "request_ns"))]
        pub request: Option<Duration>,
        /// Until the device has answered it.
        #[serde(rename(serialize = "response_ns"))]
        pub response: Option<Duration>,
    }

    /// `[dead-time]`: the time from a set value to its effect.
    pub struct DeadTime {
        /// How many cycles of the master it takes.
        pub cycles: u32,
        /// How much time besides.
        #[serde(rename(serialize = "plus_ns"))]
        pub plus: Duration,
        /// How it comes about.
        pub about: Option<String>,
    }
}

part! {
    /// A signal of the distributed clocks.
    #[derive(Copy, Eq)]
    pub struct SyncSignal {
        /// Its period in cycles of the master, or how often it comes in one if negative: -4 is four times a cycle. 1 if
        /// absent.
        #[serde(default = "one")]
        pub cycles: i32,
        /// Its period, if that is a time of its own whatever the cycle of the master is.
        #[serde(rename(serialize = "period_ns"))]
        pub period: Option<Duration>,
        /// How much later than the cycle it comes; earlier if negative.
        #[serde(default, rename(serialize = "shift_ns"))]
        pub shift: Delay,
        /// How many cycles of the master it comes later besides.
        pub shift_cycles: Option<i32>,
        /// Whether it is counted from the inputs, not from the outputs.
        #[serde(default)]
        pub of_inputs: bool,
    }
}

fn one() -> i32 {
    1
}

/// What a limit of cycle times holds for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LimitedUse {
    /// The modes of operation, by all of their codes; all modes that have no limit of their own if there are none.
    pub modes: Vec<i8>,
    /// The PDOs that are meant for them, by index.
    pub pdos: Vec<u16>,
}

impl Device {
    /// What a limit of its cycle times holds for.
    pub fn limited_use(&self, limit: &CycleTime) -> LimitedUse {
        let others = |code: i16| {
            let mode = self.modes.iter().find(move |mode| mode.code == code || mode.aliases.contains(&code));
            mode.into_iter().flat_map(|mode| mode.aliases.iter().copied().chain([mode.code]))
        };
        let mut modes: Vec<i16> = limit.modes.iter().flat_map(|code| others(*code).chain([*code])).collect();
        modes.sort_unstable();
        modes.dedup();
        let pdos = self.pdos.iter().filter(|pdo| pdo.mode.is_some_and(|mode| modes.contains(&mode)));
        let pdos = pdos.map(|pdo| pdo.index.0).collect();
        LimitedUse { modes: modes.into_iter().filter_map(|mode| i8::try_from(mode).ok()).collect(), pdos }
    }

    /// Whether it takes a cycle time in a configuration.
    pub fn takes_cycle(&self, configuration: &Configuration, time: Duration) -> bool {
        let limits: Vec<_> = self.cycle_times.iter().map(|limit| (limit, self.limited_use(limit))).collect();
        let choices: Vec<Vec<u64>> =
            limits.iter().map(|(limit, _)| limit.choices.iter().map(|choice| choice.0).collect()).collect();
        let limits = limits.iter().zip(&choices).map(|((limit, holds_for), choices_ns)| CycleLimit {
            least_ns: limit.min.map_or(0, |min| min.0),
            choices_ns,
            modes: &holds_for.modes,
            pdos: &holds_for.pdos,
        });
        let [outputs, inputs] = [Direction::Rx, Direction::Tx].map(|way| self.pdos_in(configuration, way));
        let mode = configuration.mode.and_then(|mode| i8::try_from(mode).ok());
        let interface = Interface { mode, pdos: [&outputs, &inputs] };
        interface.takes(&limits.collect::<Vec<_>>(), time.0)
    }

    /// The PDOs that are assigned in a configuration.
    fn pdos_in(&self, configuration: &Configuration, way: Direction) -> Vec<MappedPdo<'static>> {
        let pdo = |index: u16| MappedPdo::new(index, &[]);
        match configuration.assigned(way) {
            Some(pdos) => pdos.iter().map(|index| pdo(index.0)).collect(),
            None => self.assigned(Role::of(way)).map(|it| pdo(it.index.0)).collect(),
        }
    }
}
