//! Large lists in large pages: a ray that goes all over a large tree waits less for the addresses of its pages.
#![allow(unsafe_code)]

/// Shorter lists stay as they are.
const LEAST: usize = 4 << 20;

/// Asks for large pages for the room of a list before anything is written there. It is only a wish: where the system
/// has none nothing changes.
pub(super) fn ask_for_large<T>(list: &Vec<T>) {
    let bytes = list.capacity() * size_of::<T>();
    if bytes >= LEAST {
        advise(list.as_ptr().cast(), bytes);
    }
}

#[cfg(target_os = "linux")]
fn advise(start: *const u8, bytes: usize) {
    const PAGE: usize = 4096;
    // Whole pages only: what else is in the first one is not ours.
    let skipped = start.align_offset(PAGE);
    let whole = bytes.saturating_sub(skipped) / PAGE * PAGE;
    // SAFETY: the range belongs to the list, and the advice changes nothing of what is in it.
    unsafe { libc::madvise(start.wrapping_add(skipped).cast_mut().cast(), whole, libc::MADV_HUGEPAGE) };
}

#[cfg(not(target_os = "linux"))]
fn advise(_start: *const u8, _bytes: usize) {}
