//! From raw tokens to a tree; `None` wherever the walk would do more than evaluate.
use super::node::{Node, Op};
use super::{Level, Program};
use crate::keyword::Kw;
use crate::parser::float_fn::unary;
use crate::parser::num::Num;
use crate::parser::scope::{Entry, Scopes};
use crate::parser::symbol::Symbol;
use crate::parser::token::{Lexed, Lexeme};

/// Brackets within one another; deeper expressions are walked.
const MAX_DEPTH: u32 = 40;

/// The tree of the expression at token `start`, if it is plain and what follows can't be a part of it.
pub fn compile(file: &Lexed, start: u32, end: u32, level: Level, scopes: &Scopes) -> Option<Program> {
    let mut compiler = Compiler { file, pos: start, end, scopes, depth: 0 };
    let root = match level {
        Level::Additive => compiler.additive()?,
        Level::Full => compiler.full()?,
        Level::Argument => match compiler.additive()? {
            Node::Var(_) | Node::Item(..) => return None,
            root => root,
        },
    };
    // A name could be a macro with more operators, a directive could do anything.
    match compiler.peek()? {
        Lexeme::Kw(_) | Lexeme::Number(_) | Lexeme::String(_) | Lexeme::Punct(_) => {}
        Lexeme::Ident(_) | Lexeme::Directive(_) | Lexeme::Error(_) => return None,
    }
    Some(Program { level, root, end: compiler.pos, scalar: true.into() })
}

struct Compiler<'a> {
    file: &'a Lexed,
    pos: u32,
    end: u32,
    scopes: &'a Scopes,
    depth: u32,
}

impl Compiler<'_> {
    /// `None` at the end of the walk's frame as well: there the caller's text goes on.
    fn peek(&self) -> Option<Lexeme> {
        (self.pos < self.end).then(|| self.file.tokens[self.pos as usize].lexeme())
    }

    fn accept(&mut self, c: char) -> bool {
        let found = self.peek() == Some(Lexeme::Punct(c));
        self.pos += u32::from(found);
        found
    }

    fn expect(&mut self, c: char) -> Option<()> {
        self.accept(c).then_some(())
    }

    /// Left-associative operators of one strength.
    fn chain(
        &mut self,
        operand: impl Fn(&mut Self) -> Option<Node>,
        op: impl Fn(char) -> Option<Op>,
    ) -> Option<Node> {
        let mut left = operand(self)?;
        while let Some(Lexeme::Punct(c)) = self.peek()
            && let Some(op) = op(c)
        {
            self.pos += 1;
            left = Node::Binary(op, Box::new([left, operand(self)?]));
        }
        Some(left)
    }

    fn full(&mut self) -> Option<Node> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return None;
        }
        let condition = self.chain(Self::relation, |c| match c {
            '&' => Some(Op::And),
            '|' => Some(Op::Or),
            _ => None,
        })?;
        let node = if self.accept('?') {
            let yes = self.full()?;
            self.expect(':')?;
            Node::Choice(Box::new([condition, yes, self.full()?]))
        } else {
            condition
        };
        self.depth -= 1;
        Some(node)
    }

    fn relation(&mut self) -> Option<Node> {
        self.chain(Self::additive, |c| match c {
            '<' => Some(Op::Less),
            '≤' => Some(Op::LessEqual),
            '=' => Some(Op::Equal),
            '≠' => Some(Op::NotEqual),
            '≥' => Some(Op::GreaterEqual),
            '>' => Some(Op::Greater),
            _ => None,
        })
    }

    fn additive(&mut self) -> Option<Node> {
        self.chain(Self::term, |c| match c {
            '+' => Some(Op::Add),
            '-' => Some(Op::Sub),
            _ => None,
        })
    }

    fn term(&mut self) -> Option<Node> {
        self.chain(Self::factor, |c| match c {
            '*' => Some(Op::Mul),
            '/' => Some(Op::Div),
            _ => None,
        })
    }

    fn factor(&mut self) -> Option<Node> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return None;
        }
        let node = if self.accept('+') {
            self.factor()?
        } else if self.accept('-') {
            Node::Neg(Box::new(self.factor()?))
        } else if self.accept('!') {
            Node::Not(Box::new(self.factor()?))
        } else {
            let operand = self.primary()?;
            self.member(operand)?
        };
        self.depth -= 1;
        Some(node)
    }

    fn member(&mut self, of: Node) -> Option<Node> {
        if !self.accept('.') {
            return Some(of);
        }
        let Some(Lexeme::Kw(kw)) = self.peek() else { return None };
        self.pos += 1;
        let index = match kw {
            Kw::X | Kw::U | Kw::Red => 0,
            Kw::Y | Kw::V | Kw::Green => 1,
            Kw::Z | Kw::Blue => 2,
            Kw::T | Kw::Filter => 3,
            Kw::Transmit => 4,
            Kw::Gray => return Some(Node::Gray(Box::new(of))),
            _ => return None,
        };
        Some(Node::Member(Box::new(of), index))
    }

    fn primary(&mut self) -> Option<Node> {
        let lexeme = self.peek()?;
        self.pos += 1;
        match lexeme {
            Lexeme::Number(i) => Some(Node::Const(self.file.numbers[i as usize])),
            Lexeme::Punct('(') => {
                let inner = self.full()?;
                self.expect(')')?;
                Some(inner)
            }
            Lexeme::Punct('<') => {
                let parts = self.list('>')?;
                (2..=5).contains(&parts.len()).then_some(Node::Vector(parts))
            }
            Lexeme::Ident(symbol) => self.identifier(symbol),
            Lexeme::Kw(kw) => self.word(kw),
            _ => None,
        }
    }

    /// Additive expressions with commas between, up to a closing character.
    fn list(&mut self, close: char) -> Option<Vec<Node>> {
        let mut parts = Vec::new();
        loop {
            parts.push(self.additive()?);
            if self.accept(close) {
                return Some(parts);
            }
            self.expect(',')?;
        }
    }

    fn identifier(&mut self, symbol: Symbol) -> Option<Node> {
        if let Some(slot) = self.scopes.lookup(symbol)
            && matches!(self.scopes.entry(slot), Entry::Macro(_))
        {
            return None;
        }
        if self.accept('(') {
            return Some(Node::Call(symbol, self.list(')')?));
        }
        let mut subscripts = Vec::new();
        while self.accept('[') {
            subscripts.push(self.additive()?);
            self.expect(']')?;
        }
        Some(if subscripts.is_empty() { Node::Var(symbol) } else { Node::Item(symbol, subscripts) })
    }

    fn word(&mut self, kw: Kw) -> Option<Node> {
        let constant = |parts: &[f64]| Some(Node::Constants(Num::vector(parts)));
        if let Some(f) = unary(kw) {
            return Some(Node::Unary(f, Box::new(self.argument()?)));
        }
        match kw {
            Kw::Pi => Some(Node::Const(std::f64::consts::PI)),
            Kw::True | Kw::Yes | Kw::On => Some(Node::Const(1.0)),
            Kw::False | Kw::No | Kw::Off => Some(Node::Const(0.0)),
            Kw::X => constant(&[1.0, 0.0, 0.0]),
            Kw::Y => constant(&[0.0, 1.0, 0.0]),
            Kw::Z => constant(&[0.0, 0.0, 1.0]),
            Kw::U => constant(&[1.0, 0.0]),
            Kw::V => constant(&[0.0, 1.0]),
            Kw::T => constant(&[0.0, 0.0, 0.0, 1.0]),
            Kw::Sqrt | Kw::Ln | Kw::Log | Kw::Asin | Kw::Acos => {
                Some(Node::Partial(kw, Box::new(self.argument()?)))
            }
            Kw::Rand => Some(Node::Rand(Box::new(self.arguments(1)?.pop()?))),
            Kw::Atan2 | Kw::Pow | Kw::Div | Kw::Mod => Some(Node::Several(kw, self.arguments(2)?)),
            Kw::Min | Kw::Max | Kw::Select => {
                self.expect('(')?;
                Some(Node::Several(kw, self.list(')')?))
            }
            Kw::Vlength | Kw::Vnormalize => Some(Node::Vectors(kw, self.arguments(1)?)),
            Kw::Vdot | Kw::Vcross | Kw::Vrotate => Some(Node::Vectors(kw, self.arguments(2)?)),
            Kw::Vaxis_rotate => Some(Node::Vectors(kw, self.arguments(3)?)),
            _ => None,
        }
    }

    /// `( full )`
    fn argument(&mut self) -> Option<Node> {
        self.expect('(')?;
        let inner = self.full()?;
        self.expect(')')?;
        Some(inner)
    }

    /// `( a, b ... )`, so many of them.
    fn arguments(&mut self, count: usize) -> Option<Vec<Node>> {
        self.expect('(')?;
        self.list(')').filter(|args| args.len() == count)
    }
}
