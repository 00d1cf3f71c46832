//! Native code of programs that are run often, for x86-64 and AArch64.
//!
//! A program counts how often it is interpreted; when that has cost about as much as compiling, one thread makes
//! machine code (Cranelift, as WebAssembly engines use it) while the others go on interpreting. The values are those of
//! the interpreter to the last bit, except for the sign and the payload of what is no number: arithmetic is the same
//! IEEE operations in the same order, everything else calls what the interpreter calls.
//!
//! Deliberately absent: whatever the code generator does not take. Such programs stay interpreted, silently.
mod code;
mod emit;
mod flow;
mod kernels;
mod operations;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, Ordering};

use crate::program::Program;
use code::Code;

/// A program is compiled after so many runs, which take about as long as compiling does: a third of a millisecond.
const RUNS: u32 = 10_000;
/// The count of a program that somebody compiles or has compiled.
const TAKEN: u32 = u32::MAX;
/// Longer programs stay interpreted, because the time to compile grows faster than they do.
const MOST_OPS: usize = 3000;

/// The native code of a program, once it is worth having.
#[derive(Debug, Default)]
pub(crate) struct Native {
    runs: AtomicU32,
    /// `None` where there can be none.
    code: OnceLock<Option<Code>>,
}

impl Native {
    /// The value of the program that this belongs to, if there is code for it and no argument is missing.
    #[inline]
    pub(crate) fn value(&self, program: &Program, args: &[f64]) -> Option<f64> {
        match self.code.get() {
            Some(code) if args.len() >= program.params.len() => code.as_ref().map(|code| code.run(args)),
            Some(_) => None,
            None => {
                self.count(program);
                None
            }
        }
    }

    /// Compiles now, if nobody has begun to; answers whether there is native code.
    pub(crate) fn prepare(&self, program: &Program) -> bool {
        if self.runs.swap(TAKEN, Ordering::Relaxed) != TAKEN {
            let code = (program.len() <= MOST_OPS).then(|| Code::of(program)).flatten();
            // Only the one that took the count comes here, so the cell is empty.
            let _ = self.code.set(code);
        }
        matches!(self.code.get(), Some(Some(_)))
    }

    /// Counts a run. Threads may lose each other's counts: nothing but the moment of compiling hangs on them.
    #[cold]
    fn count(&self, program: &Program) {
        let runs = self.runs.load(Ordering::Relaxed);
        if runs >= RUNS && runs != TAKEN {
            self.prepare(program);
        } else if runs != TAKEN {
            // A count that is taken in between must stay so.
            let _ = self.runs.compare_exchange(runs, runs + 1, Ordering::Relaxed, Ordering::Relaxed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile;
    use crate::{BinaryOp, Expr};

    #[test]
    fn code_comes_while_several_threads_evaluate() {
        let square = Expr::Binary(BinaryOp::Mul, Box::new(Expr::Slot(0)), Box::new(Expr::Slot(0)));
        let program = compile(1, &square, 2);
        assert!(program.native.code.get().is_none(), "compiled before it was run");
        std::thread::scope(|scope| {
            for t in 0..4 {
                let program = &program;
                scope.spawn(move || {
                    for x in (0..2 * RUNS).map(|k| f64::from(k + t)) {
                        assert_eq!(program.run(&[x]), x * x);
                    }
                });
            }
        });
        assert!(matches!(program.native.code.get(), Some(Some(_))), "no native code after {RUNS} runs");
    }
}
