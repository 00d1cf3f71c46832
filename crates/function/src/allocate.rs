//! Puts the values of a program into as few registers as are live at once (linear scan).
use crate::program::{Call, Code, Op};

/// Where a value is born and last needed, as operation numbers.
#[derive(Clone, Copy)]
struct Range {
    start: usize,
    end: usize,
}

/// What the scan gives: the register of each value (`None` if it is never used) and the number of registers.
pub(crate) struct Allocation {
    registers: Vec<Option<u32>>,
    pub count: usize,
}

impl Allocation {
    /// The register of a value.
    pub(crate) fn register(&self, value: u32) -> Option<u32> {
        self.registers.get(value as usize).copied().flatten()
    }
}

/// Allocates registers for `values` values. `initial` says whether a value stands in the register file from the start
/// (parameters and constants); `loops` are the operations `first..last` that repeat, inner loops before outer ones.
pub(crate) fn allocate(
    ops: &[Op],
    calls: &[Call],
    loops: &[(usize, usize)],
    initial: &[bool],
    result: u32,
) -> Allocation {
    let mut ranges: Vec<Option<Range>> = vec![None; initial.len()];
    let mut touch = |value: u32, at: usize| {
        let start = if initial[value as usize] { 0 } else { at };
        let range = ranges[value as usize].get_or_insert(Range { start, end: at });
        range.end = at;
    };
    for (at, op) in ops.iter().enumerate() {
        for_each_value(op, calls, &mut |v| touch(v, at));
    }
    touch(result, ops.len());
    for &(first, last) in loops {
        for range in ranges.iter_mut().flatten() {
            // What was there before the loop must last through all of its turns.
            if range.start < first && (first..=last).contains(&range.end) {
                range.end = last;
            }
        }
    }
    scan(&ranges, initial)
}

/// Calls `f` with every value that the operation reads or writes.
fn for_each_value(op: &Op, calls: &[Call], f: &mut impl FnMut(u32)) {
    match op.code {
        Code::Jump => {}
        Code::Call => {
            let call = &calls[op.b as usize];
            call.args.iter().chain(&call.outputs).for_each(|&v| f(v));
        }
        code => {
            f(op.a);
            if !code.b_is_a_number() {
                f(op.b);
            }
            if !matches!(code, Code::UnlessNegative | Code::UnlessZero) {
                f(op.dst);
            }
        }
    }
}

/// Gives registers in order of birth and takes them back at death. What an operation writes may take the place of what
/// it reads last, because every operation reads all of its operands before it writes.
fn scan(ranges: &[Option<Range>], initial: &[bool]) -> Allocation {
    let mut order: Vec<(usize, Range)> =
        ranges.iter().enumerate().filter_map(|(v, r)| r.map(|r| (v, r))).collect();
    // Values that stand there from the start come first, so none of them gets a register that was freed.
    order.sort_by_key(|&(v, r)| (!initial[v], r.start));
    let mut registers = vec![None; ranges.len()];
    let mut live: Vec<(usize, u32)> = Vec::new();
    let mut free: Vec<u32> = Vec::new();
    let mut count = 0;
    for (value, range) in order {
        if !initial[value] {
            live.retain(|&(end, register)| {
                let keep = end > range.start;
                if !keep {
                    free.push(register);
                }
                keep
            });
        }
        let register = free.pop().unwrap_or_else(|| {
            count += 1;
            count as u32 - 1
        });
        live.push((range.end, register));
        registers[value] = Some(register);
    }
    Allocation { registers, count }
}
