//! The register program that a function is evaluated by.
//!
//! A program starts from a copy of its template, a register file in which the constants already stand; then the
//! arguments are written over the first registers and the operations run in order. Jumps only skip branches of `select`
//! and repeat the body of `sum` and `prod`.
use std::sync::Arc;

use raggio_math::{Vec3, noise::noise};

use crate::builtin::{maximum, minimum};
use crate::internal::{Args, Entry};
use crate::native::Native;
use crate::{BinaryOp, Builtin, External, Function, MAX_PARAMS};

/// What an operation does with its operands `a` and `b`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Code {
    /// `a`
    Copy,
    Neg,
    Add,
    Sub,
    Mul,
    Div,
    Abs,
    Sqrt,
    Min,
    Max,
    /// Comparison and logic.
    Binary(BinaryOp),
    /// Any other built-in function of one or two arguments.
    Builtin(Builtin),
    /// `a` if `b < 0`; else the register stays as it is.
    CopyIfNegative,
    /// `a` if `b = 0`; else the register stays as it is.
    CopyIfZero,
    /// Goes on at operation `b` unless `a < 0`.
    UnlessNegative,
    /// Goes on at operation `b` unless `a = 0`.
    UnlessZero,
    /// Goes on at operation `b` unless `a <= dst`.
    UnlessAtMost,
    /// Goes on at operation `b`.
    Jump,
    /// Calls number `b` of the program's list.
    Call,
}

impl Code {
    /// The code of an operator.
    pub(crate) fn of(op: BinaryOp) -> Code {
        match op {
            BinaryOp::Add => Code::Add,
            BinaryOp::Sub => Code::Sub,
            BinaryOp::Mul => Code::Mul,
            BinaryOp::Div => Code::Div,
            other => Code::Binary(other),
        }
    }

    /// Is `b` the number of an operation or a call, and no register?
    pub(crate) fn b_is_a_number(self) -> bool {
        use Code::*;
        matches!(self, UnlessNegative | UnlessZero | UnlessAtMost | Jump | Call)
    }
}

/// One operation. Registers and targets are plain indices; before allocation registers are value numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Op {
    pub code: Code,
    pub dst: u32,
    pub a: u32,
    pub b: u32,
}

/// A call with more operands than an operation holds.
#[derive(Clone, Debug)]
pub(crate) struct Call {
    pub target: Target,
    pub args: Vec<u32>,
    /// Where the components of the answer go; only externals have more than one.
    pub outputs: Vec<u32>,
}

/// What is called.
#[derive(Clone)]
pub(crate) enum Target {
    Internal(&'static Entry),
    /// Noise of a generator, which is no operand: `x`, `y` and `z` are all.
    Noise(u8),
    User(Arc<Function>),
    External(Arc<dyn External>),
}

impl std::fmt::Debug for Target {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Target::Internal(_) => "internal function",
            Target::Noise(_) => "noise",
            Target::User(_) => "user function",
            Target::External(_) => "external function",
        })
    }
}

impl Target {
    /// The same function?
    pub(crate) fn same(&self, other: &Target) -> bool {
        match (self, other) {
            (Target::Internal(a), Target::Internal(b)) => std::ptr::eq(*a, *b),
            (Target::Noise(a), Target::Noise(b)) => a == b,
            (Target::User(a), Target::User(b)) => Arc::ptr_eq(a, b) || a.same(b),
            (Target::External(a), Target::External(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

/// A compiled expression.
#[derive(Debug)]
pub(crate) struct Program {
    pub ops: Box<[Op]>,
    pub calls: Box<[Call]>,
    /// The registers as they are before the first operation; constants stand in theirs.
    pub template: Box<[f64]>,
    /// The register of each parameter; `None` for parameters that are not used.
    pub params: Box<[Option<u32>]>,
    pub result: u32,
    /// Machine code, once the program has run often.
    pub native: Native,
}

/// Register files that fit on the stack, by size. The size is a power of two, so that masking an index keeps it in
/// bounds without a test.
trait Registers {
    fn get(&self, i: u32) -> f64;
    fn set(&mut self, i: u32, v: f64);
}

impl<const N: usize> Registers for [f64; N] {
    #[inline(always)]
    fn get(&self, i: u32) -> f64 {
        self[i as usize & (N - 1)]
    }
    #[inline(always)]
    fn set(&mut self, i: u32, v: f64) {
        self[i as usize & (N - 1)] = v;
    }
}

impl Registers for Vec<f64> {
    fn get(&self, i: u32) -> f64 {
        self[i as usize]
    }
    fn set(&mut self, i: u32, v: f64) {
        self[i as usize] = v;
    }
}

impl Program {
    /// Sizes of register files on the stack; the template is padded to one of them, if one is large enough.
    pub(crate) const SIZES: [usize; 3] = [16, 64, 512];

    /// Does it surely compute the same, bit for bit?
    pub(crate) fn same(&self, other: &Program) -> bool {
        let alike =
            |(a, b): (&Call, &Call)| a.args == b.args && a.outputs == b.outputs && a.target.same(&b.target);
        let bits = |template: &[f64]| template.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        (&self.ops, &self.params, self.result) == (&other.ops, &other.params, other.result)
            && self.calls.len() == other.calls.len()
            && self.calls.iter().zip(&other.calls).all(alike)
            && bits(&self.template) == bits(&other.template)
    }

    /// How many operations there are.
    pub(crate) fn len(&self) -> usize {
        self.ops.len()
    }

    /// The value at `args`.
    #[inline]
    pub(crate) fn run(&self, args: &[f64]) -> f64 {
        self.native.value(self, args).unwrap_or_else(|| self.interpret(args))
    }

    /// Compiles to machine code now and not after some thousand runs; answers whether there is any.
    pub(crate) fn prepare(&self) -> bool {
        self.native.prepare(self)
    }

    fn interpret(&self, args: &[f64]) -> f64 {
        match self.template.len() {
            16 => self.run_on_stack::<16>(args),
            64 => self.run_on_stack::<64>(args),
            512 => self.run_on_stack::<512>(args),
            _ => self.run_in(self.template.to_vec(), args),
        }
    }

    #[inline]
    fn run_on_stack<const N: usize>(&self, args: &[f64]) -> f64 {
        match <&[f64; N]>::try_from(&*self.template) {
            Ok(template) => self.run_in(*template, args),
            Err(_) => self.run_in(self.template.to_vec(), args),
        }
    }

    #[inline(always)]
    fn run_in(&self, mut r: impl Registers, args: &[f64]) -> f64 {
        for (i, &arg) in args.iter().enumerate() {
            if let Some(&Some(register)) = self.params.get(i) {
                r.set(register, arg);
            }
        }
        let mut next = 0;
        while let Some(op) = self.ops.get(next) {
            next += 1;
            let a = r.get(op.a);
            let value = match op.code {
                Code::Copy => a,
                Code::Neg => -a,
                Code::Add => a + r.get(op.b),
                Code::Sub => a - r.get(op.b),
                Code::Mul => a * r.get(op.b),
                Code::Div => a / r.get(op.b),
                Code::Abs => a.abs(),
                Code::Sqrt => a.sqrt(),
                Code::Min => minimum(a, r.get(op.b)),
                Code::Max => maximum(a, r.get(op.b)),
                Code::Binary(o) => o.apply(a, r.get(op.b)),
                Code::Builtin(f) => f.apply(a, r.get(op.b)),
                Code::CopyIfNegative if r.get(op.b) < 0.0 => a,
                Code::CopyIfZero if r.get(op.b) == 0.0 => a,
                Code::CopyIfNegative | Code::CopyIfZero => continue,
                Code::UnlessNegative if a < 0.0 => continue,
                Code::UnlessZero if a == 0.0 => continue,
                Code::UnlessAtMost if a <= r.get(op.dst) => continue,
                Code::UnlessNegative | Code::UnlessZero | Code::UnlessAtMost | Code::Jump => {
                    next = op.b as usize;
                    continue;
                }
                Code::Call => {
                    self.call(op.b, &mut r);
                    continue;
                }
            };
            r.set(op.dst, value);
        }
        r.get(self.result)
    }

    /// Makes call number `index`. Kept out of the loop above, which stays small.
    #[inline(never)]
    fn call(&self, index: u32, r: &mut impl Registers) {
        let Some(call) = self.calls.get(index as usize) else { return };
        if let (Target::Noise(generator), &[x, y, z], &[to]) = (&call.target, &*call.args, &*call.outputs) {
            let p = Vec3::new(r.get(x), r.get(y), r.get(z));
            return r.set(to, noise(*generator, p));
        }
        let values = match &call.target {
            Target::Noise(_) => [0.0; 5],
            Target::Internal(f) => [(f.value)(&Args::gather(&call.args, |i| r.get(i))), 0.0, 0.0, 0.0, 0.0],
            Target::User(f) => f.eval5(gather(&call.args, r, &mut [0.0; MAX_PARAMS])),
            Target::External(e) => e.eval(gather(&call.args, r, &mut [0.0; 4])),
        };
        for (&register, value) in call.outputs.iter().zip(values) {
            r.set(register, value);
        }
    }
}

/// The values of some registers, as many as `buffer` holds.
fn gather<'a>(registers: &[u32], r: &impl Registers, buffer: &'a mut [f64]) -> &'a [f64] {
    for (slot, &register) in buffer.iter_mut().zip(registers) {
        *slot = r.get(register);
    }
    let count = registers.len().min(buffer.len());
    &buffer[..count]
}
