//! What a program's registers and jumps are, as the emitter must know it.
use crate::program::{Code, Op, Program};

/// Facts about a program.
pub(super) struct Flow {
    /// By operation: does a block begin here? One more entry than there are operations.
    pub begins: Vec<bool>,
    /// By register: is it ever written? If not, it holds its constant or its parameter throughout.
    pub written: Vec<bool>,
    /// By register: is what stands there at the start read before it is written?
    pub initial: Vec<bool>,
}

impl Flow {
    /// `None` if the program is not well formed.
    pub(super) fn of(program: &Program) -> Option<Flow> {
        let (ops, registers) = (&program.ops, program.template.len());
        let mut flow = Flow {
            begins: vec![false; ops.len() + 1],
            written: vec![false; registers],
            initial: vec![false; registers],
        };
        for (at, op) in ops.iter().enumerate() {
            if let Some(target) = target(op) {
                *flow.begins.get_mut(target)? = true;
                flow.begins[at + 1] = true;
            }
            // Allocation goes by the order of operations, so what is read first in it was there from the start.
            each_read(program, op, |r| {
                if let (Some(initial), Some(false)) = (flow.initial.get_mut(r), flow.written.get(r)) {
                    *initial = true;
                }
            });
            each_written(program, op, |r| {
                if let Some(written) = flow.written.get_mut(r) {
                    *written = true;
                }
            });
        }
        let result = program.result as usize;
        if !*flow.written.get(result)? {
            flow.initial[result] = true;
        }
        Some(flow)
    }

    /// Does the program run straight through?
    pub(super) fn is_straight(&self) -> bool {
        !self.begins.contains(&true)
    }
}

/// The operation that a jump may go to.
pub(super) fn target(op: &Op) -> Option<usize> {
    use Code::*;
    matches!(op.code, UnlessNegative | UnlessZero | UnlessAtMost | Jump).then_some(op.b as usize)
}

fn each_read(program: &Program, op: &Op, mut f: impl FnMut(usize)) {
    use Code::*;
    match op.code {
        Jump => {}
        Call => {
            let args = program.calls.get(op.b as usize).map_or(&[][..], |call| &call.args);
            args.iter().for_each(|&r| f(r as usize));
        }
        code => {
            f(op.a as usize);
            if !code.b_is_a_number() {
                f(op.b as usize);
            }
            if matches!(code, CopyIfNegative | CopyIfZero | UnlessAtMost) {
                f(op.dst as usize);
            }
        }
    }
}

fn each_written(program: &Program, op: &Op, mut f: impl FnMut(usize)) {
    use Code::*;
    match op.code {
        Jump | UnlessNegative | UnlessZero | UnlessAtMost => {}
        Call => {
            let outputs = program.calls.get(op.b as usize).map_or(&[][..], |call| &call.outputs);
            outputs.iter().for_each(|&r| f(r as usize));
        }
        _ => f(op.dst as usize),
    }
}
