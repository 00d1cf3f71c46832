//! Runs a program on bounds instead of numbers.
use smallvec::SmallVec;

use super::Bounds;
use crate::internal::Args;
use crate::program::{Code, Op, Program, Target};

/// Loops of more steps than this are not followed.
const MOST_STEPS: usize = 10_000;

impl Program {
    /// Bounds of the value over the arguments' bounds.
    pub(crate) fn enclose(&self, args: &[Bounds]) -> Bounds {
        let mut r: SmallVec<[Bounds; 16]> = self.template.iter().map(|&v| Bounds::constant(v)).collect();
        for (register, &arg) in self.params.iter().zip(args) {
            if let Some(register) = register {
                r[*register as usize] = arg;
            }
        }
        let mut next = 0;
        for _ in 0..MOST_STEPS {
            let Some(op) = self.ops.get(next) else { return r[self.result as usize] };
            match self.step(op, &mut r) {
                Some(true) => next = op.b as usize,
                Some(false) => next += 1,
                None => return Bounds::UNKNOWN,
            }
        }
        Bounds::UNKNOWN
    }

    /// Does one operation; answers whether to jump, or `None` if that is undecided.
    fn step(&self, op: &Op, r: &mut [Bounds]) -> Option<bool> {
        let a = r[op.a as usize];
        let b = if op.code.b_is_a_number() { a } else { r[op.b as usize] };
        let zero = Bounds::constant(0.0);
        let value = match op.code {
            Code::Copy => a,
            Code::Neg => -a,
            Code::Add => a + b,
            Code::Sub => a - b,
            Code::Mul if op.a == op.b => a.squared(),
            Code::Mul => a * b,
            Code::Div => a / b,
            Code::Abs => a.abs(),
            Code::Sqrt => a.sqrt(),
            Code::Min => a.min(b),
            Code::Max => a.max(b),
            Code::Binary(o) => Bounds::compared(o, a, b),
            Code::Builtin(f) => Bounds::builtin(f, a, b),
            Code::CopyIfNegative | Code::CopyIfZero => {
                let old = r[op.dst as usize];
                match decide(op.code, b, zero) {
                    Some(true) => a,
                    Some(false) => old,
                    None => a.either(old),
                }
            }
            Code::UnlessNegative | Code::UnlessZero => return decide(op.code, a, zero).map(|holds| !holds),
            Code::UnlessAtMost => return decide(op.code, a, r[op.dst as usize]).map(|holds| !holds),
            Code::Jump => return Some(true),
            Code::Call => {
                self.enclose_call(op.b, r);
                return Some(false);
            }
        };
        r[op.dst as usize] = value;
        Some(false)
    }

    fn enclose_call(&self, index: u32, r: &mut [Bounds]) {
        let call = &self.calls[index as usize];
        let args: SmallVec<[Bounds; 8]> = call.args.iter().map(|&i| r[i as usize]).collect();
        let mut values = [Bounds::UNKNOWN; 5];
        match &call.target {
            Target::Internal(entry) => values[0] = enclose_internal(entry.bounds, &args),
            Target::Noise(generator) => {
                if let [x, y, z] = args[..] {
                    values[0] = super::noise::enclose(*generator, [x, y, z]);
                }
            }
            Target::User(f) => values[0] = f.enclose_openly(&args),
            Target::External(e) => values = e.enclose(&args),
        }
        for (&register, value) in call.outputs.iter().zip(values) {
            r[register as usize] = value;
        }
    }
}

/// Does the condition of a conditional operation hold?
fn decide(code: Code, a: Bounds, limit: Bounds) -> Option<bool> {
    let (a_range, limit) = (a.value, limit.value);
    if a.is_vague() {
        return None;
    }
    let (always, never) = match code {
        Code::CopyIfNegative | Code::UnlessNegative => (a_range.hi < 0.0, a_range.lo >= 0.0),
        Code::CopyIfZero | Code::UnlessZero => {
            (a_range.lo == 0.0 && a_range.hi == 0.0, !a_range.contains(0.0))
        }
        _ => (a_range.hi <= limit.lo, a_range.lo > limit.hi),
    };
    if always { Some(true) } else { never.then_some(false) }
}

/// An internal function: bounds of the point, and parameters that must be numbers.
fn enclose_internal(code: Option<fn(&Args<Bounds>) -> Bounds>, args: &[Bounds]) -> Bounds {
    let Some(code) = code else { return Bounds::UNKNOWN };
    let mut p = [0.0; 11];
    for (slot, arg) in p[1..].iter_mut().zip(args.iter().skip(3)) {
        let Some(v) = arg.as_constant() else { return Bounds::UNKNOWN };
        *slot = v;
    }
    let at = |k: usize| args.get(k).copied().unwrap_or(Bounds::constant(0.0));
    code(&Args { x: at(0), y: at(1), z: at(2), p })
}
