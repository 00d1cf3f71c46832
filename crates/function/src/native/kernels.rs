//! What native code calls: the interpreter's own functions under C's calling convention.
//!
//! None of them may panic: a panic cannot pass through native code and would end the process.
#![allow(unsafe_code)] // Arguments come as pointers, each with its reason.
use raggio_math::{Vec3, noise};

use crate::internal::{Args, Entry};
use crate::program::{Call, Target};
use crate::{Builtin, MAX_PARAMS};

/// A kernel of one, two or three numbers.
#[derive(Clone, Copy)]
pub(super) enum Kernel {
    One(extern "C" fn(f64) -> f64),
    Two(extern "C" fn(f64, f64) -> f64),
    Three(extern "C" fn(f64, f64, f64) -> f64),
}

impl Kernel {
    /// Where it is, and how many numbers it takes.
    pub(super) fn address(self) -> (usize, usize) {
        match self {
            Kernel::One(f) => (f as usize, 1),
            Kernel::Two(f) => (f as usize, 2),
            Kernel::Three(f) => (f as usize, 3),
        }
    }
}

/// The kernel of a built-in function that has no instruction.
pub(super) fn of_builtin(f: Builtin) -> Kernel {
    /// One function for each listed built-in, through the interpreter's rules.
    macro_rules! kernels {
        ($($one:ident)*; $($two:ident)*) => {
            match f {
                $(Builtin::$one => Kernel::One({
                    extern "C" fn kernel(a: f64) -> f64 {
                        Builtin::$one.apply(a, 0.0)
                    }
                    kernel
                }),)*
                $(Builtin::$two => Kernel::Two({
                    extern "C" fn kernel(a: f64, b: f64) -> f64 {
                        Builtin::$two.apply(a, b)
                    }
                    kernel
                }),)*
            }
        };
    }
    kernels! {
        Abs Acos Acosh Asin Asinh Atan Atanh Ceil Cos Cosh Degrees Exp Floor Int Ln Log Radians Sin Sinh Sqr Sqrt Tan Tanh;
        Atan2 Div Max Min Mod Pow Select
    }
}

/// Noise of a generator.
pub(super) fn of_noise(generator: u8) -> Option<Kernel> {
    extern "C" fn kernel<const GENERATOR: u8>(x: f64, y: f64, z: f64) -> f64 {
        noise::noise(GENERATOR, Vec3::new(x, y, z))
    }
    match generator {
        1 => Some(Kernel::Three(kernel::<1>)),
        2 => Some(Kernel::Three(kernel::<2>)),
        3 => Some(Kernel::Three(kernel::<3>)),
        _ => None,
    }
}

/// What makes a call of any other kind: the call, its arguments, room for the answer's components.
pub(super) type Calling = unsafe extern "C" fn(*const Call, *const f64, *mut [f64; 5]) -> f64;

/// The most arguments that a call is given here.
pub(super) fn most_args(target: &Target) -> usize {
    match target {
        Target::Internal(_) => ARGS,
        Target::Noise(_) => 3,
        Target::User(_) => MAX_PARAMS,
        Target::External(_) => 4,
    }
}

/// The kernel of a call; `None` for those that have a kernel of their own.
pub(super) fn of_call(target: &Target) -> Option<Calling> {
    match target {
        Target::User(_) => Some(user),
        Target::External(_) => Some(external),
        Target::Internal(_) | Target::Noise(_) => None,
    }
}

/// The call's arguments.
///
/// # Safety
/// `args` must point to as many numbers as [`most_args`] lets the call have.
unsafe fn arguments<'a>(call: &Call, args: *const f64) -> &'a [f64] {
    let count = call.args.len().min(most_args(&call.target));
    // SAFETY: native code has stored so many of them there.
    unsafe { std::slice::from_raw_parts(args, count) }
}

/// How many numbers the arguments of an internal function are.
pub(super) const ARGS: usize = size_of::<Args>() / size_of::<f64>();

/// Where argument number `k` of a call stands among them: they count parameters from 1.
pub(super) fn place(k: usize) -> usize {
    if k < 3 { k } else { k + 1 }
}

/// Where the kernel of internal functions is.
pub(super) fn of_internal() -> usize {
    internal as *const () as usize
}

unsafe extern "C" fn internal(entry: *const Entry, args: *const Args) -> f64 {
    // SAFETY: the entry is one of the static table, and native code has written all numbers of the arguments.
    let (entry, args) = unsafe { (&*entry, &*args) };
    (entry.value)(args)
}

unsafe extern "C" fn user(call: *const Call, args: *const f64, _: *mut [f64; 5]) -> f64 {
    // SAFETY: as above.
    let (call, args) = unsafe { (&*call, arguments(&*call, args)) };
    match &call.target {
        Target::User(f) => f.eval(args),
        _ => f64::NAN,
    }
}

unsafe extern "C" fn external(call: *const Call, args: *const f64, answer: *mut [f64; 5]) -> f64 {
    // SAFETY: as above, and the answer is room on the caller's stack that nobody else knows of.
    let (call, args) = unsafe { (&*call, arguments(&*call, args)) };
    let Target::External(e) = &call.target else { return f64::NAN };
    let components = e.eval(args);
    // SAFETY: this is room on the caller's stack that nobody else knows of.
    unsafe { answer.write(components) };
    components[0]
}
