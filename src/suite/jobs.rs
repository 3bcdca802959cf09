//! Work for several threads, each with a device of its own: a software driver compiles the shaders of one
//! device one after the other.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::channel;

use crate::gpu::Gpu;

/// Calls `work` for each of `jobs`, a thread for each of `devices`; `done` gets the number of those that are
/// done. The results are in the order of the jobs.
pub fn by_devices<J: Sync, R: Send>(
    devices: &[Gpu],
    jobs: &[J],
    work: impl Fn(&Gpu, &J) -> R + Sync,
    done: &mut dyn FnMut(usize),
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = channel();
    let mut results: Vec<(usize, R)> = std::thread::scope(|scope| {
        for gpu in devices {
            let (next, work, sender) = (&next, &work, sender.clone());
            scope.spawn(move || {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(job) = jobs.get(i) else { break };
                    if sender.send((i, work(gpu, job))).is_err() {
                        break;
                    }
                }
            });
        }
        drop(sender);
        let mut results = vec![];
        for result in receiver {
            results.push(result);
            done(results.len());
        }
        results
    });
    results.sort_by_key(|(i, _)| *i);
    results.into_iter().map(|(_, result)| result).collect()
}
