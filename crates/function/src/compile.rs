//! From the expression tree to a register program: folds constants, shares equal subexpressions, opens short calls.
//!
//! Every value gets a number. A pure operation on the same values is the same value, so it is looked up before it is
//! written; what is computed inside a branch or a loop is forgotten at its end. All rewriting is exact, but for the two
//! rules of the language itself: division by a constant is multiplication by its inverse, and powers with the
//! exponents 2 to 8 are products (language spec, section 3.2).
use std::collections::HashMap;
use std::sync::Arc;

use crate::allocate::allocate;
use crate::builtin::{select, truncate};
use crate::internal::{Args, generator_number};
use crate::native::Native;
use crate::program::{Call, Code, Op, Program, Target};
use crate::{BinaryOp, Builtin, Expr, Function, Internal, MAX_PARAMS};

/// A call of a function with at most this many operations is opened in place.
const INLINE_OPS: usize = 48;
/// No more calls are opened in a program of this length.
const LONG_PROGRAM: usize = 2048;

/// Makes the program of a function.
pub(crate) fn compile(params: usize, body: &Expr, noise_generator: u8) -> Program {
    let mut builder = Builder::default();
    let params: Vec<u32> = (0..params).map(|_| builder.initial(0.0)).collect();
    let mut frame = Frame { slots: params.clone(), noise_generator };
    let result = builder.expr(body, &mut frame);
    builder.finish(&params, result)
}

/// What the slots of the function being compiled stand for; a call opened in place has a frame of its own.
struct Frame {
    slots: Vec<u32>,
    noise_generator: u8,
}

/// What makes two operations the same.
type Key = (Code, u32, u32);

#[derive(Default)]
struct Builder {
    ops: Vec<Op>,
    calls: Vec<Call>,
    loops: Vec<(usize, usize)>,
    /// By value: what stands in its register at the start, if it is there from the start.
    initial: Vec<Option<f64>>,
    /// By value: the number that it always is, if it is one.
    constants: Vec<Option<f64>>,
    constant_values: HashMap<u64, u32>,
    known: HashMap<Key, u32>,
    /// Keys of `known` in order of entry, so that scopes can be left.
    journal: Vec<Key>,
}

impl Builder {
    /// A new value that operations write.
    fn fresh(&mut self) -> u32 {
        self.initial.push(None);
        self.constants.push(None);
        self.initial.len() as u32 - 1
    }

    /// A new value that stands in the register file from the start.
    fn initial(&mut self, v: f64) -> u32 {
        let value = self.fresh();
        self.initial[value as usize] = Some(v);
        value
    }

    fn constant(&mut self, v: f64) -> u32 {
        if let Some(&value) = self.constant_values.get(&v.to_bits()) {
            return value;
        }
        let value = self.initial(v);
        self.constants[value as usize] = Some(v);
        self.constant_values.insert(v.to_bits(), value);
        value
    }

    fn known_constant(&self, value: u32) -> Option<f64> {
        self.constants[value as usize]
    }

    fn push(&mut self, code: Code, dst: u32, a: u32, b: u32) {
        self.ops.push(Op { code, dst, a, b });
    }

    fn remember(&mut self, key: Key, value: u32) {
        if self.known.insert(key, value).is_none() {
            self.journal.push(key);
        }
    }

    /// Compiles something that may not run at all or run many times: what it computes is not known afterwards.
    fn scoped<T>(&mut self, f: impl FnOnce(&mut Self) -> T) -> T {
        let mark = self.journal.len();
        let result = f(self);
        for key in self.journal.drain(mark..) {
            self.known.remove(&key);
        }
        result
    }

    /// The value of a pure operation.
    fn operation(&mut self, code: Code, a: u32, b: u32) -> u32 {
        if let Some(&value) = self.known.get(&(code, a, b)) {
            return value;
        }
        let value = self.fresh();
        self.push(code, value, a, b);
        self.remember((code, a, b), value);
        value
    }

    fn expr(&mut self, e: &Expr, frame: &mut Frame) -> u32 {
        match e {
            Expr::Const(v) => self.constant(*v),
            Expr::Slot(n) => match frame.slots.get(*n) {
                Some(&value) => value,
                None => self.constant(0.0),
            },
            Expr::Neg(e) => {
                let a = self.expr(e, frame);
                self.negated(a)
            }
            Expr::Binary(op, a, b) => {
                let (a, b) = (self.expr(a, frame), self.expr(b, frame));
                self.binary(*op, a, b)
            }
            Expr::Call(Builtin::Select, args) => self.select(args, frame),
            Expr::Call(f, args) => {
                let args = self.all(args, frame);
                self.builtin(*f, &args)
            }
            Expr::Loop { product, slot, from, to, body } => {
                let (from, to) = (self.expr(from, frame), self.expr(to, frame));
                self.counted_loop(*product, *slot, (from, to), body, frame)
            }
            Expr::Internal(internal, args) => self.internal(*internal, args, frame),
            Expr::User(f, args) => self.user(f, args, frame),
            Expr::External { function, args, component } => {
                let args = self.all(args, frame);
                self.call(Target::External(Arc::clone(function)), args, *component)
            }
        }
    }

    fn all(&mut self, args: &[Expr], frame: &mut Frame) -> Vec<u32> {
        args.iter().map(|e| self.expr(e, frame)).collect()
    }

    fn negated(&mut self, a: u32) -> u32 {
        match self.known_constant(a) {
            Some(v) => self.constant(-v),
            None => self.operation(Code::Neg, a, a),
        }
    }

    fn binary(&mut self, op: BinaryOp, a: u32, b: u32) -> u32 {
        match (op, self.known_constant(a), self.known_constant(b)) {
            (_, Some(x), Some(y)) => self.constant(op.apply(x, y)),
            (BinaryOp::Mul | BinaryOp::Div, None, Some(1.0)) => a,
            (BinaryOp::Mul, Some(1.0), None) => b,
            (BinaryOp::Div, None, Some(y)) if y != 0.0 => {
                let inverse = self.constant(1.0 / y);
                self.binary(BinaryOp::Mul, a, inverse)
            }
            _ => {
                let (a, b) = if op.commutes() { (a.min(b), a.max(b)) } else { (a, b) };
                self.operation(Code::of(op), a, b)
            }
        }
    }

    fn builtin(&mut self, f: Builtin, args: &[u32]) -> u32 {
        match *args {
            [] => self.constant(0.0),
            [a] => self.builtin2(f, a, a),
            [a, b] => self.builtin2(f, a, b),
            [first, ref rest @ ..] => rest.iter().fold(first, |a, &b| self.builtin2(f, a, b)),
        }
    }

    /// A built-in function of two arguments; those of one argument get it twice.
    fn builtin2(&mut self, f: Builtin, a: u32, b: u32) -> u32 {
        match (f, self.known_constant(a), self.known_constant(b)) {
            (Builtin::Pow, _, Some(exponent)) => self.power(a, b, exponent),
            (_, Some(x), Some(y)) => self.constant(f.apply(x, y)),
            (Builtin::Sqr, ..) => self.binary(BinaryOp::Mul, a, a),
            (Builtin::Abs, ..) => self.operation(Code::Abs, a, a),
            (Builtin::Sqrt, ..) => self.operation(Code::Sqrt, a, a),
            (Builtin::Min, ..) => self.operation(Code::Min, a, b),
            (Builtin::Max, ..) => self.operation(Code::Max, a, b),
            _ => self.operation(Code::Builtin(f), a, b),
        }
    }

    /// A power with a constant exponent.
    fn power(&mut self, a: u32, b: u32, exponent: f64) -> u32 {
        match (self.known_constant(a), exponent) {
            (_, 0.0) => self.constant(1.0),
            (_, 1.0) => a,
            (_, n) if n == truncate(n) && (2.0..=8.0).contains(&n) => self.product(a, n as u32),
            (Some(x), _) => self.constant(x.powf(exponent)),
            _ => self.operation(Code::Builtin(Builtin::Pow), a, b),
        }
    }

    /// `a` multiplied by itself, by repeated squaring.
    fn product(&mut self, a: u32, n: u32) -> u32 {
        if n == 1 {
            return a;
        }
        let half = self.product(a, n / 2);
        let square = self.binary(BinaryOp::Mul, half, half);
        if n % 2 == 1 { self.binary(BinaryOp::Mul, square, a) } else { square }
    }

    /// `select(a, less, [equal,] greater)`: only the chosen branch runs.
    fn select(&mut self, args: &[Expr], frame: &mut Frame) -> u32 {
        let (a, less, equal, greater) = match args {
            [a, less, greater] => (a, less, None, greater),
            [a, less, equal, greater] => (a, less, Some(equal), greater),
            _ => return self.constant(0.0),
        };
        let a = self.expr(a, frame);
        if let Some(v) = self.known_constant(a) {
            let chosen = match select(v, -1.0, 0.0, 1.0) {
                c if c < 0.0 => less,
                0.0 => equal.unwrap_or(greater),
                _ => greater,
            };
            return self.expr(chosen, frame);
        }
        let simple = |e: &Expr| matches!(e, Expr::Const(_) | Expr::Slot(_));
        if [Some(less), equal, Some(greater)].into_iter().flatten().all(simple) {
            return self.select_values(a, [Some(less), equal, Some(greater)], frame);
        }
        let result = self.fresh();
        let mut to_end = Vec::new();
        for (code, branch) in [(Code::UnlessNegative, Some(less)), (Code::UnlessZero, equal)] {
            let Some(branch) = branch else { continue };
            let test = self.jump(code, a);
            self.branch(result, branch, frame);
            to_end.push(self.jump(Code::Jump, a));
            self.land(test);
        }
        self.branch(result, greater, frame);
        to_end.into_iter().for_each(|jump| self.land(jump));
        result
    }

    /// A `select` between values that are there anyway needs no jumps.
    fn select_values(&mut self, a: u32, branches: [Option<&Expr>; 3], frame: &mut Frame) -> u32 {
        let [less, equal, greater] = branches.map(|e| e.map(|e| self.expr(e, frame)));
        let result = self.fresh();
        for (code, value) in [(Code::Copy, greater), (Code::CopyIfZero, equal), (Code::CopyIfNegative, less)]
        {
            if let Some(value) = value {
                self.push(code, result, value, a);
            }
        }
        result
    }

    fn branch(&mut self, result: u32, e: &Expr, frame: &mut Frame) {
        self.scoped(|b| {
            let value = b.expr(e, frame);
            b.push(Code::Copy, result, value, value);
        });
    }

    /// Writes a jump whose target is not known yet.
    fn jump(&mut self, code: Code, a: u32) -> usize {
        self.push(code, a, a, 0);
        self.ops.len() - 1
    }

    /// Lets a jump lead to here.
    fn land(&mut self, jump: usize) {
        self.ops[jump].b = self.ops.len() as u32;
    }

    /// `sum` and `prod`: the counter runs from `from` in steps of 1 while it is at most `to`.
    fn counted_loop(
        &mut self,
        product: bool,
        slot: usize,
        (from, to): (u32, u32),
        body: &Expr,
        frame: &mut Frame,
    ) -> u32 {
        let (counter, total) = (self.fresh(), self.fresh());
        let one = self.constant(1.0);
        let start = if product { one } else { self.constant(0.0) };
        self.push(Code::Copy, counter, from, from);
        self.push(Code::Copy, total, start, start);
        let first = self.ops.len();
        self.push(Code::UnlessAtMost, to, counter, 0);
        if frame.slots.len() <= slot {
            let zero = self.constant(0.0);
            frame.slots.resize(slot + 1, zero);
        }
        let outer = std::mem::replace(&mut frame.slots[slot], counter);
        let term = self.scoped(|b| b.expr(body, frame));
        frame.slots[slot] = outer;
        self.push(if product { Code::Mul } else { Code::Add }, total, total, term);
        self.push(Code::Add, counter, counter, one);
        self.push(Code::Jump, counter, counter, first as u32);
        self.loops.push((first, self.ops.len() - 1));
        self.land(first);
        total
    }

    fn internal(&mut self, internal: Internal, args: &[Expr], frame: &mut Frame) -> u32 {
        let mut args = self.all(args, frame);
        if internal == Internal::NOISE {
            args.truncate(3);
            args.push(self.constant(f64::from(frame.noise_generator)));
        }
        let internal = if internal == Internal::NOISE { Internal::NOISE_OF_GENERATOR } else { internal };
        let (entry, params) = internal.implementation();
        let zero = self.constant(0.0);
        args.resize(params, zero);
        if args.iter().all(|&a| self.known_constant(a).is_some()) {
            let known = Args::gather(&args, |a| self.known_constant(a).unwrap_or(0.0));
            return self.constant((entry.value)(&known));
        }
        match (internal, self.known_constant(args[params - 1])) {
            (Internal::NOISE_OF_GENERATOR, Some(generator)) => {
                args.truncate(3);
                self.call(Target::Noise(generator_number(generator)), args, 0)
            }
            _ => self.call(Target::Internal(entry), args, 0),
        }
    }

    /// A call of another user function: opened in place if it is short.
    fn user(&mut self, f: &Arc<Function>, args: &[Expr], frame: &mut Frame) -> u32 {
        let mut args = self.all(args, frame);
        let zero = self.constant(0.0);
        args.resize(f.params(), zero);
        let most = if f.params() > MAX_PARAMS {
            usize::MAX
        } else if self.ops.len() < LONG_PROGRAM {
            INLINE_OPS
        } else {
            1
        };
        match f.inlinable(most) {
            Some((body, noise_generator)) => self.expr(body, &mut Frame { slots: args, noise_generator }),
            None => match f.as_external() {
                Some(e) => self.call(Target::External(Arc::clone(e)), args, 0),
                None => self.call(Target::User(Arc::clone(f)), args, 0),
            },
        }
    }

    /// Component `component` of a call's answer. A call that was made already is not made again.
    fn call(&mut self, target: Target, args: Vec<u32>, component: usize) -> u32 {
        let same = |c: &Call| c.target.same(&target) && c.args == args;
        let known = (0..self.calls.len())
            .rev()
            .find(|&i| same(&self.calls[i]) && self.known.contains_key(&(Code::Call, i as u32, 0)));
        let index = known.unwrap_or_else(|| {
            let components = if matches!(target, Target::External(_)) { 5 } else { 1 };
            let outputs = (0..components).map(|_| self.fresh()).collect();
            let index = self.calls.len();
            self.calls.push(Call { target, args, outputs });
            self.push(Code::Call, 0, 0, index as u32);
            self.remember((Code::Call, index as u32, 0), index as u32);
            index
        });
        match self.calls[index].outputs.get(component) {
            Some(&value) => value,
            None => self.constant(0.0),
        }
    }

    /// Allocates registers and writes them into the operations.
    fn finish(mut self, params: &[u32], result: u32) -> Program {
        let initial: Vec<bool> = self.initial.iter().map(Option::is_some).collect();
        let allocation = allocate(&self.ops, &self.calls, &self.loops, &initial, result);
        let place = |value: u32| allocation.register(value).unwrap_or(0);
        for op in &mut self.ops {
            (op.dst, op.a) = (place(op.dst), place(op.a));
            if !op.code.b_is_a_number() {
                op.b = place(op.b);
            }
        }
        for call in &mut self.calls {
            call.args.iter_mut().chain(&mut call.outputs).for_each(|v| *v = place(*v));
        }
        let size = Program::SIZES.into_iter().find(|&n| allocation.count <= n).unwrap_or(allocation.count);
        let mut template = vec![0.0; size];
        for (value, v) in self.initial.iter().enumerate() {
            if let (Some(v), Some(register)) = (v, allocation.register(value as u32)) {
                template[register as usize] = *v;
            }
        }
        Program {
            ops: self.ops.into(),
            calls: self.calls.into(),
            template: template.into(),
            params: params.iter().map(|&p| allocation.register(p)).collect(),
            result: place(result),
            native: Native::default(),
        }
    }
}
