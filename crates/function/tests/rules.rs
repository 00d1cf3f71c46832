//! The numeric rules of user functions, as POV-Ray 3.7 shows them, and the laws of the compiler.
use std::any::Any;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use proptest::prelude::*;
use raggio_function::{BinaryOp, Builtin, Expr, External, Function};

fn slot(n: usize) -> Expr {
    Expr::Slot(n)
}

fn number(v: f64) -> Expr {
    Expr::Const(v)
}

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    Expr::Binary(op, Box::new(a), Box::new(b))
}

/// The value of a built-in function, once with constants and once with parameters.
fn call(f: Builtin, args: &[f64]) -> f64 {
    let folded = Function::new(0, Expr::Call(f, args.iter().copied().map(number).collect())).eval(&[]);
    let run = Function::new(args.len(), Expr::Call(f, (0..args.len()).map(slot).collect())).eval(args);
    assert!(same(folded, run), "{f:?} {args:?}: {folded} folded, {run} run");
    run
}

fn same(a: f64, b: f64) -> bool {
    a == b || (a.is_nan() && b.is_nan())
}

#[test]
fn built_in_functions_follow_the_program() {
    use Builtin::*;
    const NAN: f64 = f64::NAN;
    let cases: &[(Builtin, &[f64], f64)] = &[
        (Int, &[-1.5], -1.0),
        (Int, &[3e9], -2147483648.0),
        (Int, &[NAN], -2147483648.0),
        (Div, &[-7.0, 2.0], -3.0),
        (Mod, &[-7.0, 2.0], -1.0),
        (Mod, &[7.0, -2.5], 2.0),
        (Mod, &[7.0, 0.0], NAN),
        (Pow, &[-2.0, 3.0], -8.0),
        (Pow, &[-2.0, 0.5], NAN),
        (Pow, &[3.0, 0.0], 1.0),
        (Pow, &[3.0, 5.0], 243.0),
        (Sqrt, &[-1.0], NAN),
        (Asin, &[2.0], NAN),
        (Ln, &[0.0], f64::NEG_INFINITY),
        (Log, &[1000.0], 3.0),
        (Atan2, &[0.0, 0.0], 0.0),
        (Sqr, &[-3.0], 9.0),
        (Min, &[NAN, 1.0], 1.0),
        (Min, &[1.0, NAN], NAN),
        (Min, &[1.0, NAN, 2.0], 2.0),
        (Max, &[NAN, 1.0], NAN),
        (Max, &[1.0, NAN], 1.0),
        (Max, &[1.0, 2.0, NAN], 2.0),
        (Max, &[1.0, 4.0, 2.0], 4.0),
        (Select, &[-1.0, 1.0, 2.0], 1.0),
        (Select, &[0.0, 1.0, 2.0], 2.0),
        (Select, &[0.0, 1.0, 2.0, 3.0], 2.0),
        (Select, &[-0.5, 1.0, 2.0, 3.0], 1.0),
        (Select, &[NAN, 1.0, 2.0, 3.0], 3.0),
        (Degrees, &[std::f64::consts::PI], 180.0),
    ];
    for &(f, args, expected) in cases {
        let value = call(f, args);
        assert!(same(value, expected), "{f:?} {args:?}: {value} instead of {expected}");
    }
}

#[test]
fn not_a_number_is_greater_than_everything() {
    use BinaryOp::*;
    for (op, expected) in [(Lt, 0.0), (Le, 0.0), (Eq, 0.0), (Ne, 1.0), (Gt, 1.0), (Ge, 1.0)] {
        let f = Function::new(2, binary(op, slot(0), slot(1)));
        assert_eq!(f.eval(&[f64::NAN, 1.0]), expected, "nan {op:?} 1");
        assert_eq!(f.eval(&[1.0, f64::NAN]), expected, "1 {op:?} nan");
    }
    let and = Function::new(2, binary(And, slot(0), slot(1)));
    assert_eq!((and.eval(&[0.5, -1.0]), and.eval(&[f64::NAN, 1.0]), and.eval(&[0.0, 1.0])), (1.0, 1.0, 0.0));
}

fn counted(product: bool, body: Expr) -> Function {
    let (from, to, body) = (Box::new(slot(0)), Box::new(slot(1)), Box::new(body));
    Function::new(2, Expr::Loop { product, slot: 2, from, to, body })
}

#[test]
fn sums_and_products_run_in_steps_of_one() {
    let sum = counted(false, slot(2));
    assert_eq!((sum.eval(&[1.0, 4.0]), sum.eval(&[1.5, 4.0]), sum.eval(&[4.0, 1.0])), (10.0, 7.5, 0.0));
    let product = counted(true, slot(2));
    assert_eq!((product.eval(&[1.0, 5.0]), product.eval(&[4.0, 1.0])), (120.0, 1.0));
    assert_eq!(sum.eval(&[f64::NAN, 4.0]), 0.0);
}

#[test]
fn what_a_loop_needs_outlasts_its_turns() {
    // sum(k, a, b, (a + b) * k + 3): the sum a + b is computed before the loop and needed in every turn.
    let total = binary(BinaryOp::Add, slot(0), slot(1));
    let term = binary(BinaryOp::Add, binary(BinaryOp::Mul, total.clone(), slot(2)), number(3.0));
    let f = counted(false, term);
    assert_eq!(f.eval(&[1.0, 3.0]), 4.0 * 6.0 + 9.0);
    let nested = Expr::Loop {
        product: false,
        slot: 3,
        from: Box::new(number(1.0)),
        to: Box::new(slot(2)),
        body: Box::new(binary(BinaryOp::Mul, total, slot(3))),
    };
    assert_eq!(counted(false, nested).eval(&[1.0, 3.0]), 4.0 * (1.0 + 3.0 + 6.0));
}

#[derive(Debug, Default)]
struct Counter(AtomicUsize);

impl External for Counter {
    fn eval(&self, args: &[f64]) -> [f64; 5] {
        self.0.fetch_add(1, Ordering::Relaxed);
        [args[0], args[1], args[2], 4.0, 5.0]
    }
    fn components(&self) -> usize {
        5
    }
    fn as_any(&self) -> &dyn Any {
        self
    }
}

fn component(function: &Arc<Counter>, component: usize) -> Expr {
    Expr::External { function: Arc::clone(function) as _, args: vec![slot(0), slot(1), slot(2)], component }
}

#[test]
fn one_call_gives_all_components_of_an_external_function() {
    let counter = Arc::new(Counter::default());
    let sum = binary(BinaryOp::Add, component(&counter, 2), component(&counter, 4));
    let f = Function::new(3, binary(BinaryOp::Add, component(&counter, 0), sum));
    assert_eq!(f.eval(&[10.0, 20.0, 30.0]), 45.0);
    assert_eq!(counter.0.load(Ordering::Relaxed), 1);
    let direct = Function::external(3, Arc::clone(&counter) as _);
    assert_eq!(direct.eval5(&[1.0, 2.0, 3.0]), [1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!((direct.components(), direct.eval(&[1.0, 2.0, 3.0])), (5, 1.0));
}

#[test]
fn only_the_chosen_branch_runs() {
    let counter = Arc::new(Counter::default());
    let costly = component(&counter, 0);
    let f = Function::new(
        3,
        Expr::Call(
            Builtin::Select,
            vec![slot(0), costly.clone(), binary(BinaryOp::Add, slot(1), number(1.0))],
        ),
    );
    assert_eq!(f.eval(&[1.0, 2.0, 3.0]), 3.0);
    assert_eq!(counter.0.load(Ordering::Relaxed), 0);
    assert_eq!(f.eval(&[-1.0, 2.0, 3.0]), -1.0);
    assert_eq!(counter.0.load(Ordering::Relaxed), 1);
    // What ran inside a branch may not be taken for known after it.
    let after = binary(
        BinaryOp::Add,
        Expr::Call(
            Builtin::Select,
            vec![slot(0), costly.clone(), binary(BinaryOp::Add, slot(1), number(1.0))],
        ),
        costly,
    );
    assert_eq!(Function::new(3, after).eval(&[5.0, 2.0, 3.0]), 8.0);
}

#[test]
fn long_functions_are_called_and_short_ones_opened() {
    let step = |e: Expr| Expr::Call(Builtin::Sin, vec![binary(BinaryOp::Mul, e, slot(1))]);
    let long = Arc::new(Function::new(2, (0..100).fold(slot(0), |e, _| step(e))));
    let short = Arc::new(Function::new(2, binary(BinaryOp::Sub, slot(0), slot(1))));
    let f = Function::new(
        1,
        Expr::User(short, vec![Expr::User(Arc::clone(&long), vec![slot(0), number(2.0)]), number(1.0)]),
    );
    assert_eq!(f.eval(&[0.7]), long.eval(&[0.7, 2.0]) - 1.0);
}

#[test]
fn wide_functions_need_many_registers() {
    // All products are wanted at once, so none of the registers can be freed before the end.
    let products: Vec<Expr> =
        (0..700).map(|i| binary(BinaryOp::Mul, slot(0), number(f64::from(i) + 0.5))).collect();
    let sum = products.clone().into_iter().reduce(|a, b| binary(BinaryOp::Add, b, a));
    let all = products.into_iter().rev().fold(sum.expect("terms"), |a, b| binary(BinaryOp::Add, a, b));
    assert_eq!(Function::new(1, all).eval(&[2.0]), 2.0 * 2.0 * (700.0 * 699.0 / 2.0 + 350.0));
}

#[test]
fn missing_arguments_read_zero() {
    let f = Function::new(2, binary(BinaryOp::Add, slot(0), slot(1)));
    assert_eq!((f.eval(&[1.0]), f.eval(&[1.0, 2.0, 3.0])), (1.0, 3.0));
    assert_eq!(Function::new(1, slot(7)).eval(&[1.0]), 0.0);
}

/// Trees over two parameters and constants whose inverses are exact, so that folding may change nothing at all.
fn tree() -> impl Strategy<Value = Expr> {
    let exact = prop::sample::select(vec![-4.0, -1.0, -0.5, 0.0, 0.25, 1.0, 2.0, 16.0]);
    let leaf = prop_oneof![exact.prop_map(number), (0..2usize).prop_map(slot)];
    leaf.clone().prop_recursive(6, 60, 4, move |inner| {
        use BinaryOp::*;
        let op = prop::sample::select(vec![Add, Sub, Mul, Eq, Ne, Lt, Le, Gt, Ge, And, Or]);
        let one = prop::sample::select(vec![Builtin::Abs, Builtin::Sin, Builtin::Floor, Builtin::Exp]);
        let two = prop::sample::select(vec![Builtin::Min, Builtin::Max, Builtin::Mod, Builtin::Atan2]);
        prop_oneof![
            (op, inner.clone(), inner.clone()).prop_map(|(op, a, b)| binary(op, a, b)),
            (inner.clone(), leaf.clone()).prop_map(|(a, b)| binary(Div, a, b)),
            (one, inner.clone()).prop_map(|(f, a)| Expr::Call(f, vec![a])),
            (two, inner.clone(), inner.clone()).prop_map(|(f, a, b)| Expr::Call(f, vec![a, b])),
            inner.clone().prop_map(|a| Expr::Neg(Box::new(a))),
            prop::collection::vec(inner, 3..=4).prop_map(|args| Expr::Call(Builtin::Select, args)),
        ]
    })
}

/// The meaning of a tree, read off without any compiling.
fn meaning(e: &Expr, args: &[f64]) -> f64 {
    let value = |e: &Expr| meaning(e, args);
    match e {
        Expr::Const(v) => *v,
        Expr::Slot(n) => args[*n],
        Expr::Neg(e) => -value(e),
        Expr::Call(Builtin::Select, list) => match value(&list[0]) {
            a if a < 0.0 => value(&list[1]),
            0.0 => value(&list[2]),
            _ => value(&list[list.len() - 1]),
        },
        Expr::Call(f, list) => {
            let plain = Expr::Call(*f, (0..list.len()).map(slot).collect());
            let list: Vec<f64> = list.iter().map(value).collect();
            Function::new(list.len(), plain).eval(&list)
        }
        Expr::Binary(op, a, b) => Function::new(2, binary(*op, slot(0), slot(1))).eval(&[value(a), value(b)]),
        other => panic!("{other:?} is not generated"),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(1), ..ProptestConfig::default() })]

    #[test]
    fn compiling_does_not_change_the_meaning(e in tree(), a in -4.0..4.0f64, b in -2.0..2.0f64) {
        let compiled = Function::new(2, e.clone()).eval(&[a, b]);
        let plain = meaning(&e, &[a, b]);
        prop_assert!(same(compiled, plain), "{} compiled, {} plain", compiled, plain);
    }
}
