//! One operation as instructions. Each is the interpreter's formula, in the same order and with the same rounding.
use cranelift_codegen::cursor::FuncCursor;
use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::{InstBuilder, Value};

use super::kernels::{self, Kernel};
use crate::builtin::RADIAN;
use crate::program::Code;
use crate::{BinaryOp, Builtin};

/// How an operation without control flow is done.
pub(super) enum Done {
    /// By instructions, with this value.
    Inline(Value),
    /// By calling a function of the first operands.
    Kernel(Kernel),
}

/// The operation `code` on `a` and `b`, where `old` is what the register holds before.
pub(super) fn emit(
    cursor: &mut FuncCursor,
    code: Code,
    a: Value,
    b: Value,
    old: Option<Value>,
) -> Option<Done> {
    let mut c = Instructions(cursor);
    Some(Done::Inline(match code {
        Code::Copy => a,
        Code::Neg => c.0.ins().fneg(a),
        Code::Add => c.0.ins().fadd(a, b),
        Code::Sub => c.0.ins().fsub(a, b),
        Code::Mul => c.0.ins().fmul(a, b),
        Code::Div => c.0.ins().fdiv(a, b),
        Code::Abs => c.0.ins().fabs(a),
        Code::Sqrt => c.0.ins().sqrt(a),
        Code::Min => c.either(FloatCC::LessThan, (a, b), a, b),
        Code::Max => c.either(FloatCC::LessThan, (a, b), b, a),
        Code::Binary(op) => c.binary(op, a, b),
        Code::Builtin(f) => return c.builtin(f, a, b),
        Code::CopyIfNegative | Code::CopyIfZero => {
            let zero = c.number(0.0);
            let holds = if code == Code::CopyIfZero { FloatCC::Equal } else { FloatCC::LessThan };
            c.either(holds, (b, zero), a, old?)
        }
        Code::UnlessNegative | Code::UnlessZero | Code::UnlessAtMost | Code::Jump | Code::Call => {
            return None;
        }
    }))
}

/// Short words for the instructions that formulas are made of.
struct Instructions<'c, 'f>(&'c mut FuncCursor<'f>);

impl Instructions<'_, '_> {
    fn number(&mut self, v: f64) -> Value {
        self.0.ins().f64const(v)
    }

    /// `then` where the comparison of the two holds, else `other`.
    fn either(&mut self, holds: FloatCC, (a, b): (Value, Value), then: Value, other: Value) -> Value {
        let holds = self.0.ins().fcmp(holds, a, b);
        self.0.ins().select(holds, then, other)
    }

    /// A condition as 1, or as 0 if it does not hold.
    fn truth(&mut self, condition: Value) -> Value {
        let (one, zero) = (self.number(1.0), self.number(0.0));
        self.0.ins().select(condition, one, zero)
    }

    fn binary(&mut self, op: BinaryOp, a: Value, b: Value) -> Value {
        let condition = match op {
            BinaryOp::Add => return self.0.ins().fadd(a, b),
            BinaryOp::Sub => return self.0.ins().fsub(a, b),
            BinaryOp::Mul => return self.0.ins().fmul(a, b),
            BinaryOp::Div => return self.0.ins().fdiv(a, b),
            BinaryOp::Eq => self.0.ins().fcmp(FloatCC::Equal, a, b),
            BinaryOp::Ne => self.0.ins().fcmp(FloatCC::NotEqual, a, b),
            BinaryOp::Lt => self.0.ins().fcmp(FloatCC::LessThan, a, b),
            BinaryOp::Le => self.0.ins().fcmp(FloatCC::LessThanOrEqual, a, b),
            // What is no number counts as greater.
            BinaryOp::Gt => self.0.ins().fcmp(FloatCC::UnorderedOrGreaterThan, a, b),
            BinaryOp::Ge => self.0.ins().fcmp(FloatCC::UnorderedOrGreaterThanOrEqual, a, b),
            BinaryOp::And | BinaryOp::Or => {
                let zero = self.number(0.0);
                let a = self.0.ins().fcmp(FloatCC::NotEqual, a, zero);
                let b = self.0.ins().fcmp(FloatCC::NotEqual, b, zero);
                if op == BinaryOp::And { self.0.ins().band(a, b) } else { self.0.ins().bor(a, b) }
            }
        };
        self.truth(condition)
    }

    fn builtin(&mut self, f: Builtin, a: Value, b: Value) -> Option<Done> {
        Some(Done::Inline(match f {
            Builtin::Floor if rounds() => self.0.ins().floor(a),
            Builtin::Ceil if rounds() => self.0.ins().ceil(a),
            Builtin::Int if rounds() => self.truncated(a),
            Builtin::Div if rounds() => {
                let quotient = self.0.ins().fdiv(a, b);
                self.truncated(quotient)
            }
            Builtin::Degrees | Builtin::Radians => {
                let radian = self.number(RADIAN);
                if f == Builtin::Degrees {
                    self.0.ins().fdiv(a, radian)
                } else {
                    self.0.ins().fmul(a, radian)
                }
            }
            other => return Some(Done::Kernel(kernels::of_builtin(other))),
        }))
    }

    /// The interpreter's `truncate`: what does not fit into 32 bits becomes their least number.
    fn truncated(&mut self, a: Value) -> Value {
        let whole = self.0.ins().trunc(a);
        let (least, most) = (self.number(f64::from(i32::MIN)), self.number(f64::from(i32::MAX)));
        let from = self.0.ins().fcmp(FloatCC::GreaterThanOrEqual, whole, least);
        let to = self.0.ins().fcmp(FloatCC::LessThanOrEqual, whole, most);
        let fits = self.0.ins().band(from, to);
        // Minus zero becomes zero.
        let zero = self.number(0.0);
        let whole = self.0.ins().fadd(whole, zero);
        self.0.ins().select(fits, whole, least)
    }
}

/// Has the processor an instruction for rounding to whole numbers?
fn rounds() -> bool {
    #[cfg(target_arch = "x86_64")]
    return is_x86_feature_detected!("sse4.1");
    #[cfg(not(target_arch = "x86_64"))]
    true
}
