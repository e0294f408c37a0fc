//! Work for all cores.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, Builder, ScopedJoinHandle};

/// How many threads share the work.
#[derive(Debug, Clone, Copy)]
pub(super) struct Workers(NonZero<usize>);

impl Workers {
    /// One thread, so that what is measured has the machine for itself.
    pub(super) const ONE: Self = Self(NonZero::<usize>::MIN);

    /// A thread for each core that the process may use.
    pub(super) fn all() -> Self {
        thread::available_parallelism().map_or(Self::ONE, Self)
    }

    /// Makes something of each item; the results are in the order of the items, whoever made them.
    pub(super) fn map<T: Sync, R: Send>(self, items: &[T], make: impl Fn(&T) -> R + Sync) -> Vec<R> {
        let next = AtomicUsize::new(0);
        let work = || {
            let numbers = std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
            let taken = numbers.map_while(|number| Some((number, items.get(number)?)));
            taken.map(|(number, item)| (number, make(item))).collect::<Vec<_>>()
        };
        let mut made = thread::scope(|scope| {
            let others = 1..self.0.get().min(items.len());
            // where the system has no more threads, those that there are do the work
            let others = others.filter_map(|_| Builder::new().spawn_scoped(scope, work).ok());
            let others: Vec<ScopedJoinHandle<'_, Vec<(usize, R)>>> = others.collect();
            let own = work();
            let others =
                others.into_iter().flat_map(|other| other.join().unwrap_or_else(|it| resume_unwind(it)));
            own.into_iter().chain(others).collect::<Vec<_>>()
        });
        made.sort_by_key(|(number, _)| *number);
        made.into_iter().map(|(_, result)| result).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_the_order_of_the_items() {
        let items: Vec<u32> = (0..1000).collect();
        let four = Workers(NonZero::new(4).unwrap());
        for workers in [Workers::ONE, Workers::all(), four] {
            let made = workers.map(&items, |item| item * 2);
            assert!(made.iter().zip(&items).all(|(made, item)| *made == item * 2), "{workers:?}");
            assert_eq!(made.len(), items.len(), "{workers:?}");
        }
    }

    #[test]
    fn no_work_has_no_results() {
        assert!(Workers::all().map(&[], |(): &()| ()).is_empty());
    }
}
