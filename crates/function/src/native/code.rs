//! Machine code in memory: written first, then made executable and never writable again.
#![allow(unsafe_code)] // A call of code that was made at run time, with its reason.
use std::sync::OnceLock;

use cranelift_codegen::Context;
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::isa::{self, OwnedTargetIsa};
use cranelift_codegen::settings::{self, Configurable};
use memmap2::{Mmap, MmapMut};
use target_lexicon::Triple;

use super::emit;
use crate::program::Program;

/// The entry: reads the arguments, gives the value.
type Entry = unsafe extern "C" fn(*const f64) -> f64;

/// The machine code of one program. It holds addresses of the program's list of calls, so it may not outlive it.
#[derive(Debug)]
pub(super) struct Code {
    /// Keeps the code where it is.
    _memory: Mmap,
    entry: Entry,
    params: usize,
}

impl Code {
    /// Compiles a program; `None` if the processor, the system or the code generator refuses.
    pub(super) fn of(program: &Program) -> Option<Code> {
        let isa = processor()?;
        let mut context = Context::for_function(emit::function(program, isa)?);
        let compiled = context.compile(&**isa, &mut ControlPlane::default()).ok()?;
        // All addresses stand in the code as numbers; a relocation would be a call of a library that is not linked.
        if !compiled.buffer.relocs().is_empty() {
            return None;
        }
        let bytes = compiled.code_buffer();
        let mut memory = MmapMut::map_anon(bytes.len()).ok()?;
        memory.get_mut(..bytes.len())?.copy_from_slice(bytes);
        let memory = memory.make_exec().ok()?;
        synchronise(&memory)?;
        // SAFETY: the memory begins with a function of this signature, as `emit::function` declares it, compiled for
        // this processor and its calling convention.
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(memory.as_ptr()) };
        Some(Code { _memory: memory, entry, params: program.params.len() })
    }

    /// The value at `args`, which must be as many as there are parameters.
    #[inline]
    pub(super) fn run(&self, args: &[f64]) -> f64 {
        debug_assert!(args.len() >= self.params);
        // SAFETY: the code reads one number for each parameter, and `Native::value` has counted them; what it calls
        // lives as long as the program that owns this code.
        unsafe { (self.entry)(args.as_ptr()) }
    }
}

/// Lets all threads see new code, where data and instructions have caches that do not know of each other.
#[cfg(target_arch = "aarch64")]
fn synchronise(memory: &Mmap) -> Option<()> {
    use wasmtime_internal_jit_icache_coherence::{clear_cache, pipeline_flush_mt};
    // SAFETY: the range is that of a live mapping.
    unsafe { clear_cache(memory.as_ptr().cast(), memory.len()) }.ok()?;
    pipeline_flush_mt().ok()
}

/// On this architecture caches agree by themselves.
#[cfg(not(target_arch = "aarch64"))]
fn synchronise(_memory: &Mmap) -> Option<()> {
    Some(())
}

/// Cranelift's settings. Large frames touch each of their pages in order, so that none steps over a stack's end.
const SETTINGS: [(&str, &str); 5] = [
    ("opt_level", "none"),
    ("enable_verifier", "false"),
    ("unwind_info", "false"),
    ("enable_probestack", "true"),
    ("probestack_strategy", "inline"),
];

/// The code generator for this processor. Code is not optimised any further: the program is already folded and shared.
fn processor() -> Option<&'static OwnedTargetIsa> {
    static PROCESSOR: OnceLock<Option<OwnedTargetIsa>> = OnceLock::new();
    let make = || {
        let mut flags = settings::builder();
        for (name, value) in SETTINGS {
            flags.set(name, value).ok()?;
        }
        let mut builder = isa::lookup(Triple::host()).ok()?;
        for feature in features() {
            builder.enable(feature).ok()?;
        }
        builder.finish(settings::Flags::new(flags)).ok()
    };
    PROCESSOR.get_or_init(make).as_ref()
}

/// What the processor has beyond the least of its kind, by Cranelift's names. Fused products stay out: they round
/// otherwise than the interpreter.
fn features() -> Vec<&'static str> {
    #[cfg(target_arch = "x86_64")]
    {
        let known = [
            ("has_sse3", is_x86_feature_detected!("sse3")),
            ("has_ssse3", is_x86_feature_detected!("ssse3")),
            ("has_sse41", is_x86_feature_detected!("sse4.1")),
            ("has_sse42", is_x86_feature_detected!("sse4.2")),
            ("has_avx", is_x86_feature_detected!("avx")),
        ];
        known.into_iter().take_while(|&(_, there)| there).map(|(name, _)| name).collect()
    }
    #[cfg(not(target_arch = "x86_64"))]
    Vec::new()
}
