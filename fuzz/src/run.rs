//! Inputs for a property: kept ones, new ones, and those of a fuzzer.

use std::fmt::Debug;
use std::panic::RefUnwindSafe;

use bolero::TypeGenerator;

/// Asks whether a property holds, of a fuzzer's inputs.
#[cfg(fuzzing)]
pub(crate) fn holds<T: Debug + TypeGenerator>(_: &str, _: usize, property: impl Fn(&T) + RefUnwindSafe) {
    bolero::check!().with_type::<T>().for_each(property);
}

/// Asks whether a property holds, of the inputs that are kept under a name and of so many new ones; `DEVC_FUZZ` asks for
/// that many times as many.
#[cfg(not(fuzzing))]
pub(crate) fn holds<T: Debug + TypeGenerator>(
    name: &'static str,
    count: usize,
    property: impl Fn(&T) + RefUnwindSafe,
) {
    let engine = steady::Steady { name, count };
    bolero::TestTarget::new(engine).with_type::<T>().for_each(property);
}

#[cfg(not(fuzzing))]
mod steady {
    use std::fmt::Debug;
    use std::fs;
    use std::path::{Path, PathBuf};
    use std::time::Duration;

    use bolero_engine::driver::Options;
    use bolero_engine::input::Bytes;
    use bolero_engine::panic::{forward_panic, set_hook};
    use bolero_engine::{Engine, Test};

    /// Long enough for any input, as far as the work is bounded at all.
    const PATIENCE: Duration = Duration::from_secs(30);

    /// How many bytes a new input has at most.
    const LENGTH: usize = 400;

    /// An engine whose inputs are the same in every run.
    pub(super) struct Steady {
        pub(super) name: &'static str,
        pub(super) count: usize,
    }

    impl<T: Test> Engine<T> for Steady
    where
        T::Value: Debug,
    {
        type Output = ();

        fn run(self, mut test: T, options: Options) {
            let times = std::env::var("DEVC_FUZZ").ok().and_then(|times| times.parse().ok()).unwrap_or(1);
            let new = (0..self.count * times).map(|seed| (format!("seed {seed}"), chance(seed as u64)));
            set_hook();
            for (name, bytes) in kept(self.name).into_iter().chain(new) {
                let start = time();
                let forwarded = forward_panic(false);
                let failure = test.test(&mut Bytes::new(&bytes, &options)).err().map(|why| {
                    let smaller = test.shrink(bytes.clone(), None, &options);
                    smaller.map_or_else(|| why.to_string(), |smaller| format!("{smaller:#}"))
                });
                forward_panic(forwarded);
                assert!(failure.is_none(), "{name}: {}", failure.unwrap_or_default());
                let taken = time().saturating_sub(start);
                assert!(taken < PATIENCE, "{name}: {taken:?}");
            }
        }
    }

    /// The time that this thread had a processor for, so that what else the machine does is not counted; nothing where the
    /// system does not tell.
    fn time() -> Duration {
        let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
        let told = told.and_then(|text| text.split(' ').next()?.parse().ok());
        told.map_or(Duration::ZERO, Duration::from_nanos)
    }

    /// The inputs that are kept, by name.
    fn kept(name: &str) -> Vec<(String, Vec<u8>)> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(name);
        let entries = fs::read_dir(folder).into_iter().flatten().map(|entry| entry.expect("an entry").path());
        let mut files: Vec<PathBuf> = entries.collect();
        files.sort();
        let read = |path: PathBuf| {
            let bytes = fs::read(&path).expect("a file");
            (path.display().to_string(), bytes)
        };
        files.into_iter().map(read).collect()
    }

    /// Bytes that look like chance (xorshift64*).
    fn chance(seed: u64) -> Vec<u8> {
        let mut state = (seed + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        let mut next = || {
            state ^= state >> 12;
            state ^= state << 25;
            state ^= state >> 27;
            state.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32
        };
        let length = 8 + next() as usize % LENGTH;
        (0..length).map(|_| next() as u8).collect()
    }
}
