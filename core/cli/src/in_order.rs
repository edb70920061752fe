//! Many files at a time, their results in the order of the files.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Does `work` on every item, several at a time, and hands each result to `emit` as soon as it and all before it are
/// there. Stops to take new items where `stop` is true or `emit` says so.
///
/// Threads of our own rather than the core's pool: a worker of the pool that waits for the inner loops of one file
/// would begin another whole file meanwhile, and hold back the first one's result.
pub fn for_each<T: Sync, R: Send>(
    items: &[T],
    workers: Option<u16>,
    stop: &AtomicBool,
    work: impl Fn(&T) -> R + Sync,
    emit: impl FnMut(R) -> ControlFlow<()> + Send,
) {
    let threads = workers.map_or_else(|| thread::available_parallelism().map_or(1, usize::from), usize::from);
    let next = AtomicUsize::new(0);
    let queue = Mutex::new(Queue { waiting: BTreeMap::new(), wanted: 0, emit });
    let take = || loop {
        let index = next.fetch_add(1, Ordering::Relaxed);
        let Some(item) = items.get(index).filter(|_| !stop.load(Ordering::Relaxed)) else { break };
        let result = work(item);
        // The queue is only ever changed whole: a panic in another worker ends the scope anyway.
        let mut queue = queue.lock().unwrap_or_else(PoisonError::into_inner);
        if queue.put(index, result).is_break() {
            next.store(items.len(), Ordering::Relaxed);
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads.min(items.len()) {
            scope.spawn(take);
        }
        take();
    });
}

struct Queue<R, E> {
    waiting: BTreeMap<usize, R>,
    wanted: usize,
    emit: E,
}

impl<R, E: FnMut(R) -> ControlFlow<()>> Queue<R, E> {
    fn put(&mut self, index: usize, result: R) -> ControlFlow<()> {
        self.waiting.insert(index, result);
        while let Some(result) = self.waiting.remove(&self.wanted) {
            self.wanted += 1;
            (self.emit)(result)?;
        }
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn results_come_in_the_order_of_the_items() {
        let items: Vec<u64> = (0..40).collect();
        let mut seen = Vec::new();
        let slow_at_first = |item: &u64| {
            thread::sleep(Duration::from_millis(20_u64.saturating_sub(*item)));
            *item
        };
        for_each(&items, Some(4), &AtomicBool::new(false), slow_at_first, |item| {
            seen.push(item);
            ControlFlow::Continue(())
        });
        assert_eq!(seen, items);
    }

    #[test]
    fn nothing_is_begun_once_stopped() {
        let begun = AtomicUsize::new(0);
        let stop = AtomicBool::new(false);
        let work = |_: &u32| {
            stop.store(true, Ordering::Relaxed);
            begun.fetch_add(1, Ordering::Relaxed);
        };
        for_each(&[0; 50], Some(1), &stop, work, |()| ControlFlow::Continue(()));
        assert_eq!(begun.into_inner(), 1);
    }

    #[test]
    fn a_reader_that_has_gone_ends_the_work() {
        let begun = AtomicUsize::new(0);
        let work = |_: &u32| begun.fetch_add(1, Ordering::Relaxed);
        for_each(&[0; 50], Some(1), &AtomicBool::new(false), work, |_| ControlFlow::Break(()));
        assert_eq!(begun.into_inner(), 1);
    }
}
