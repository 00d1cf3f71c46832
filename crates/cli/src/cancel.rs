//! Ctrl-C and SIGTERM: the first asks for an end, the second makes one.
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A flag that the first interruption raises. The second one ends the program at once.
pub(crate) fn on_interrupt() -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    let raised = Arc::clone(&flag);
    let set = ctrlc::set_handler(move || {
        if raised.swap(true, Ordering::Relaxed) {
            std::process::exit(2);
        }
    });
    // Without a handler an interruption ends the program as usual; nothing else is lost.
    let _ = set;
    flag
}
