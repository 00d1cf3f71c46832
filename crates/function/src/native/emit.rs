//! From a program to the code generator's language.
//!
//! Where a program runs straight through, each register is a value. Where it jumps, registers live in a frame on the
//! stack between blocks and are values within one, which spares looking for the places where values meet.
use cranelift_codegen::cursor::{Cursor, FuncCursor};
use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::types::F64;
use cranelift_codegen::ir::{
    AbiParam, Block, Function, InstBuilder, MemFlags, SigRef, Signature, StackSlot, StackSlotData,
    StackSlotKind, Type, UserFuncName, Value,
};
use cranelift_codegen::isa::OwnedTargetIsa;

use super::flow::{self, Flow};
use super::kernels::{self, Kernel};
use super::operations::{self, Done};
use crate::internal::Entry;
use crate::program::{Call, Code, Op, Program, Target};

/// Bytes of a number.
const SIZE: u32 = 8;
/// How many components an answer has at most.
const COMPONENTS: u32 = 5;

/// The program as a function from a pointer to its arguments to its value; `None` if it is not well formed.
pub(super) fn function(program: &Program, isa: &OwnedTargetIsa) -> Option<Function> {
    let mut signature = Signature::new(isa.default_call_conv());
    signature.params.push(AbiParam::new(isa.pointer_type()));
    signature.returns.push(AbiParam::new(F64));
    let mut function = Function::with_name_signature(UserFuncName::default(), signature);
    let mut emitter = Emitter::new(program, isa, &mut function)?;
    emitter.begin();
    emitter.operations()?;
    Some(function)
}

struct Emitter<'a> {
    program: &'a Program,
    isa: &'a OwnedTargetIsa,
    cursor: FuncCursor<'a>,
    flow: Flow,
    /// By operation: the block that begins there.
    blocks: Vec<Option<Block>>,
    /// By register: its value, where this block has it.
    values: Vec<Option<Value>>,
    /// Registers whose frame does not hold their value.
    changed: Vec<usize>,
    /// Where registers live between blocks, if there are blocks.
    frame: Option<StackSlot>,
    /// Arguments and answers of calls that have no kernel of their own.
    room: Option<[StackSlot; 2]>,
    /// Signatures of kernels of so many numbers.
    signatures: [Option<SigRef>; 4],
    calling: Option<SigRef>,
    internal: Option<SigRef>,
}

impl<'a> Emitter<'a> {
    fn new(program: &'a Program, isa: &'a OwnedTargetIsa, function: &'a mut Function) -> Option<Self> {
        let flow = Flow::of(program)?;
        let registers = program.template.len();
        let cursor = FuncCursor::new(function);
        let mut slot = |numbers: usize| {
            let data = StackSlotData::new(StackSlotKind::ExplicitSlot, numbers as u32 * SIZE, 3);
            cursor.func.create_sized_stack_slot(data)
        };
        let frame = (!flow.is_straight()).then(|| slot(registers));
        let most = program.calls.iter().map(|c| kernels::most_args(&c.target)).max();
        let room = most.map(|most| [slot(most), slot(COMPONENTS as usize)]);
        let blocks = flow.begins.iter().map(|&begins| begins.then(|| cursor.func.dfg.make_block())).collect();
        Some(Emitter {
            program,
            isa,
            cursor,
            flow,
            blocks,
            values: vec![None; registers],
            changed: Vec::new(),
            frame,
            room,
            signatures: [None; 4],
            calling: None,
            internal: None,
        })
    }

    /// The first block: arguments, and constants whose registers are used again for something else.
    fn begin(&mut self) {
        let block = self.cursor.func.dfg.make_block();
        self.cursor.insert_block(block);
        let args = self.cursor.func.dfg.append_block_param(block, self.isa.pointer_type());
        for (k, register) in self.program.params.iter().enumerate() {
            if let Some(register) = register {
                let value = self.cursor.ins().load(F64, MemFlags::trusted(), args, k as i32 * SIZE as i32);
                self.write(*register as usize, value);
            }
        }
        for register in 0..self.values.len() {
            if self.values[register].is_none() && self.flow.initial[register] && self.flow.written[register] {
                let value = self.cursor.ins().f64const(self.program.template[register]);
                self.write(register, value);
            }
        }
    }

    fn operations(&mut self) -> Option<()> {
        for (at, op) in self.program.ops.iter().enumerate() {
            self.enter(at);
            self.operation(at, op)?;
        }
        self.enter(self.program.ops.len());
        let result = self.read(self.program.result)?;
        self.cursor.ins().return_(&[result]);
        Some(())
    }

    /// Begins the block at an operation, if one begins there.
    fn enter(&mut self, at: usize) {
        let Some(block) = self.blocks[at] else { return };
        let open = self.cursor.current_block().is_some_and(|block| {
            let last = self.cursor.func.layout.last_inst(block);
            !last.is_some_and(|last| self.cursor.func.dfg.insts[last].opcode().is_terminator())
        });
        if open {
            self.leave();
            self.cursor.ins().jump(block, &[]);
        }
        self.cursor.insert_block(block);
    }

    /// Writes what the block has changed to the frame, and forgets all values.
    fn leave(&mut self) {
        for register in std::mem::take(&mut self.changed) {
            if let (Some(frame), Some(value)) = (self.frame, self.values[register]) {
                self.cursor.ins().stack_store(value, frame, register as i32 * SIZE as i32);
            }
        }
        self.values.fill(None);
    }

    fn operation(&mut self, at: usize, op: &Op) -> Option<()> {
        match op.code {
            Code::Call => return self.call(self.program.calls.get(op.b as usize)?),
            Code::Jump | Code::UnlessNegative | Code::UnlessZero | Code::UnlessAtMost => {
                return self.jump(at, op);
            }
            _ => {}
        }
        let (a, b) = (self.read(op.a)?, self.read(op.b)?);
        let copies = matches!(op.code, Code::CopyIfNegative | Code::CopyIfZero);
        let old = if copies { Some(self.read(op.dst)?) } else { None };
        let value = match operations::emit(&mut self.cursor, op.code, a, b, old)? {
            Done::Inline(value) => value,
            Done::Kernel(kernel) => self.kernel(kernel, &[a, b]),
        };
        self.write(op.dst as usize, value);
        Some(())
    }

    fn jump(&mut self, at: usize, op: &Op) -> Option<()> {
        let (target, next) = (self.blocks[flow::target(op)?]?, self.blocks[at + 1]?);
        let condition = match op.code {
            Code::Jump => None,
            Code::UnlessAtMost => Some((FloatCC::LessThanOrEqual, self.read(op.a)?, self.read(op.dst)?)),
            code => {
                let zero = self.cursor.ins().f64const(0.0);
                let holds = if code == Code::UnlessZero { FloatCC::Equal } else { FloatCC::LessThan };
                Some((holds, self.read(op.a)?, zero))
            }
        };
        self.leave();
        match condition {
            None => self.cursor.ins().jump(target, &[]),
            Some((holds, a, b)) => {
                let holds = self.cursor.ins().fcmp(holds, a, b);
                self.cursor.ins().brif(holds, next, &[], target, &[])
            }
        };
        Some(())
    }

    /// Calls a kernel of as many of the values as it takes.
    fn kernel(&mut self, kernel: Kernel, values: &[Value]) -> Value {
        let (address, count) = kernel.address();
        let signature = match self.signatures[count] {
            Some(signature) => signature,
            None => self.signature(&[F64, F64, F64][..count]),
        };
        self.signatures[count] = Some(signature);
        self.call_address(signature, address, &values[..count])
    }

    fn signature(&mut self, params: &[Type]) -> SigRef {
        let mut signature = Signature::new(self.isa.default_call_conv());
        signature.params.extend(params.iter().map(|&t| AbiParam::new(t)));
        signature.returns.push(AbiParam::new(F64));
        self.cursor.func.import_signature(signature)
    }

    fn call_address(&mut self, signature: SigRef, address: usize, args: &[Value]) -> Value {
        let callee = self.cursor.ins().iconst(self.isa.pointer_type(), address as i64);
        let call = self.cursor.ins().call_indirect(signature, callee, args);
        self.cursor.func.dfg.first_result(call)
    }

    fn call(&mut self, call: &Call) -> Option<()> {
        if let Target::Noise(generator) = call.target {
            let point = [
                self.read(*call.args.first()?)?,
                self.read(*call.args.get(1)?)?,
                self.read(*call.args.get(2)?)?,
            ];
            let value = self.kernel(kernels::of_noise(generator)?, &point);
            self.write(*call.outputs.first()? as usize, value);
            return Some(());
        }
        if let Target::Internal(entry) = call.target {
            let value = self.call_internal(entry, &call.args)?;
            self.write(*call.outputs.first()? as usize, value);
            return Some(());
        }
        let [args, answer] = self.room?;
        for (k, &register) in call.args.iter().take(kernels::most_args(&call.target)).enumerate() {
            let value = self.read(register)?;
            self.cursor.ins().stack_store(value, args, k as i32 * SIZE as i32);
        }
        let pointer = self.isa.pointer_type();
        let signature = match self.calling {
            Some(signature) => signature,
            None => self.signature(&[pointer; 3]),
        };
        self.calling = Some(signature);
        let address = kernels::of_call(&call.target)? as usize;
        let which = self.cursor.ins().iconst(pointer, std::ptr::from_ref(call) as i64);
        let args = self.cursor.ins().stack_addr(pointer, args, 0);
        let out = self.cursor.ins().stack_addr(pointer, answer, 0);
        let first = self.call_address(signature, address, &[which, args, out]);
        for (k, &register) in call.outputs.iter().enumerate() {
            let value = match k {
                0 => first,
                _ => self.cursor.ins().stack_load(F64, answer, k as i32 * SIZE as i32),
            };
            self.write(register as usize, value);
        }
        Some(())
    }

    /// Calls an internal function; parameters that are missing are 0.
    fn call_internal(&mut self, entry: &'static Entry, registers: &[u32]) -> Option<Value> {
        let [args, _] = self.room?;
        let mut values = [None; kernels::ARGS];
        for (k, &register) in registers.iter().enumerate() {
            *values.get_mut(kernels::place(k))? = Some(self.read(register)?);
        }
        let zero = self.cursor.ins().f64const(0.0);
        for (k, value) in values.into_iter().enumerate() {
            self.cursor.ins().stack_store(value.unwrap_or(zero), args, k as i32 * SIZE as i32);
        }
        let pointer = self.isa.pointer_type();
        let signature = match self.internal {
            Some(signature) => signature,
            None => self.signature(&[pointer; 2]),
        };
        self.internal = Some(signature);
        let which = self.cursor.ins().iconst(pointer, std::ptr::from_ref(entry) as i64);
        let args = self.cursor.ins().stack_addr(pointer, args, 0);
        Some(self.call_address(signature, kernels::of_internal(), &[which, args]))
    }

    /// The value of a register.
    fn read(&mut self, register: u32) -> Option<Value> {
        let register = register as usize;
        if let Some(value) = *self.values.get(register)? {
            return Some(value);
        }
        Some(match self.frame {
            Some(frame) if self.flow.written[register] || self.is_param(register) => {
                let value = self.cursor.ins().stack_load(F64, frame, register as i32 * SIZE as i32);
                self.values[register] = Some(value);
                value
            }
            // Constants are made anew at each use, where they are operands in memory; kept, they would be spilled.
            _ => self.cursor.ins().f64const(self.program.template[register]),
        })
    }

    fn is_param(&self, register: usize) -> bool {
        self.program.params.contains(&Some(register as u32))
    }

    fn write(&mut self, register: usize, value: Value) {
        if self.frame.is_some() && !self.changed.contains(&register) {
            self.changed.push(register);
        }
        self.values[register] = Some(value);
    }
}
