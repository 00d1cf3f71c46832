//! Native code gives what the interpreter gives, to the last bit; what is no number may differ in sign and payload.
#![cfg(all(feature = "native", any(target_arch = "x86_64", target_arch = "aarch64"), not(miri)))]
use std::any::Any;
use std::sync::Arc;

use proptest::prelude::*;
use raggio_function::{BinaryOp, Builtin, Expr, External, Function, Internal};

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    Expr::Binary(op, Box::new(a), Box::new(b))
}

/// The function as the interpreter runs it, and as native code.
fn both(params: usize, body: Expr) -> [Function; 2] {
    let [plain, native] = [body.clone(), body].map(|body| Function::new(params, body));
    assert!(native.prepare(), "no native code for {native:?}");
    [plain, native]
}

/// Numbers of all kinds.
fn number() -> impl Strategy<Value = f64> {
    let special = vec![
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.5,
        2.0,
        -2.5,
        3e9,
        -3e9,
        1e300,
        -1e300,
        5e-324,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];
    prop_oneof![3 => -4.0..4.0f64, 2 => prop::sample::select(special), 1 => prop::num::f64::ANY]
}

/// An answer of five components that depends on all arguments.
#[derive(Debug)]
struct Five;

impl External for Five {
    fn eval(&self, args: &[f64]) -> [f64; 5] {
        let sum: f64 = args.iter().sum();
        [sum, args[0] - sum, 2.0 * sum, sum * sum, args.len() as f64]
    }
    fn components(&self) -> usize {
        5
    }
    fn as_any(&self) -> &dyn Any {
        self
    }
}

fn operators(inner: BoxedStrategy<Expr>) -> impl Strategy<Value = Expr> {
    use BinaryOp::*;
    use Builtin::*;
    let op =
        prop::sample::select(vec![Add, Sub, BinaryOp::Mul, BinaryOp::Div, Eq, Ne, Lt, Le, Gt, Ge, And, Or]);
    let one = prop::sample::select(vec![
        Abs, Acos, Acosh, Asin, Asinh, Atan, Atanh, Ceil, Cos, Cosh, Degrees, Exp, Floor, Int, Ln, Log,
        Radians, Sin, Sinh, Sqr, Sqrt, Tan, Tanh,
    ]);
    let two = prop::sample::select(vec![Atan2, Builtin::Div, Max, Min, Mod, Pow]);
    prop_oneof![
        4 => (op, inner.clone(), inner.clone()).prop_map(|(op, a, b)| binary(op, a, b)),
        3 => (one, inner.clone()).prop_map(|(f, a)| Expr::Call(f, vec![a])),
        2 => (two, inner.clone(), inner.clone()).prop_map(|(f, a, b)| Expr::Call(f, vec![a, b])),
        1 => inner.clone().prop_map(|a| Expr::Neg(Box::new(a))),
        1 => prop::collection::vec(inner, 3..=4).prop_map(|args| Expr::Call(Select, args)),
    ]
}

/// At most seven turns, whatever the operands are; the counter is slot 3.
fn counted(product: bool, from: Expr, to: Expr, body: Expr) -> Expr {
    let from = Box::new(Expr::Call(Builtin::Max, vec![from, Expr::Const(-2.0)]));
    let to = Box::new(Expr::Call(Builtin::Min, vec![to, Expr::Const(4.0)]));
    Expr::Loop { product, slot: 3, from, to, body: Box::new(body) }
}

fn calls(inner: BoxedStrategy<Expr>) -> impl Strategy<Value = Expr> {
    let known = (0..79u8).prop_filter("a function", |&n| Internal(n).params().is_some());
    let args = prop::collection::vec(inner.clone(), 3);
    let long = (0..60).fold(Expr::Slot(0), |e, k| {
        let sum = binary(BinaryOp::Add, e, Expr::Const(0.25 * f64::from(k)));
        Expr::Call(Builtin::Cos, vec![binary(BinaryOp::Mul, sum, Expr::Slot(1))])
    });
    let long = Arc::new(Function::new(2, long));
    prop_oneof![
        1 => (any::<bool>(), inner.clone(), inner.clone(), inner.clone())
            .prop_map(|(product, from, to, body)| counted(product, from, to, body)),
        1 => (known, prop::collection::vec(inner.clone(), 3..8)).prop_map(|(n, args)| Expr::Internal(Internal(n), args)),
        1 => (inner.clone(), inner).prop_map(move |(a, b)| Expr::User(Arc::clone(&long), vec![a, b])),
        1 => (args, 0..5usize).prop_map(|(args, component)| Expr::External { function: Arc::new(Five), args, component }),
    ]
}

/// Trees of everything, over three parameters.
fn tree() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![1 => number().prop_map(Expr::Const), 3 => (0..4usize).prop_map(Expr::Slot)];
    leaf.prop_recursive(6, 80, 4, |inner| prop_oneof![4 => operators(inner.clone()), 1 => calls(inner)])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(1), ..ProptestConfig::default() })]

    #[test]
    fn native_code_equals_the_interpreter(
        e in tree(),
        points in prop::collection::vec(prop::array::uniform3(number()), 6),
    ) {
        let [plain, native] = both(3, e);
        for p in points {
            let (plain, native) = (plain.eval(&p), native.eval(&p));
            prop_assert!(same(plain, native), "{:e} interpreted, {:e} native at {:?}", plain, native, p);
        }
    }
}

#[test]
fn every_operator_is_exact_on_special_numbers() {
    use BinaryOp::*;
    let numbers =
        [0.0, -0.0, 1.0, -1.0, 2.5, -7.0, 3e9, -2147483648.5, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    let mut bodies: Vec<Expr> = [Add, Sub, Mul, Div, Eq, Ne, Lt, Le, Gt, Ge, And, Or]
        .map(|op| binary(op, Expr::Slot(0), Expr::Slot(1)))
        .into();
    use Builtin as B;
    let two = [B::Atan2, B::Div, B::Max, B::Min, B::Mod, B::Pow];
    bodies.extend(two.map(|f| Expr::Call(f, vec![Expr::Slot(0), Expr::Slot(1)])));
    let one = [B::Abs, B::Ceil, B::Degrees, B::Floor, B::Int, B::Radians, B::Sin, B::Sqr, B::Sqrt];
    bodies.extend(one.map(|f| Expr::Call(f, vec![Expr::Slot(0)])));
    for body in bodies {
        let [plain, native] = both(2, body.clone());
        for (a, b) in numbers.iter().flat_map(|&a| numbers.map(|b| (a, b))) {
            let (plain, native) = (plain.eval(&[a, b]), native.eval(&[a, b]));
            assert!(same(plain, native), "{body:?} of {a}, {b}: {plain} interpreted, {native} native");
        }
    }
}

#[test]
fn the_recorded_values_of_internal_functions_hold_in_native_code() {
    let mut checked = 0;
    for line in include_str!("data/internals.csv").lines() {
        let mut fields = line.split(';');
        let mut field = || fields.next().expect("three fields");
        let n = Internal(field().parse().expect("a number"));
        let args: Vec<f64> = field().split(',').map(|v| v.parse().expect("an argument")).collect();
        let expected: f64 = field().parse().expect("a value");
        let count = n.params().expect("a function of this number");
        let [plain, native] = both(count, Expr::Internal(n, (0..count).map(Expr::Slot).collect()));
        let value = native.eval(&args);
        assert!((value - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{n:?} {args:?}: {value}");
        assert!(same(value, plain.eval(&args)), "{n:?} {args:?}");
        checked += 1;
    }
    assert_eq!(checked, 390);
}

#[test]
fn noise_has_the_scenes_generator() {
    for generator in 1..=3 {
        let noise = || Expr::Internal(Internal::NOISE, (0..3).map(Expr::Slot).collect());
        let [plain, native] = [noise(), noise()].map(|e| Function::with_noise_generator(3, e, generator));
        assert!(native.prepare());
        for k in 0..100 {
            let p = [0.37, -1.21, 2.93].map(|v| v * f64::from(k));
            assert!(same(plain.eval(&p), native.eval(&p)), "generator {generator} at {p:?}");
        }
    }
}

#[test]
fn missing_arguments_read_zero_in_native_code_too() {
    let [plain, native] = both(2, binary(BinaryOp::Add, Expr::Slot(0), Expr::Slot(1)));
    for args in [&[][..], &[1.5], &[1.5, 2.0], &[1.5, 2.0, 3.0]] {
        assert!(same(plain.eval(args), native.eval(args)), "{args:?}");
    }
}

#[test]
fn programs_that_are_too_long_stay_interpreted() {
    let long =
        (0..4000).fold(Expr::Slot(0), |e, k| binary(BinaryOp::Add, e, Expr::Const(f64::from(k) + 0.5)));
    let f = Function::new(1, long);
    assert!(!f.prepare());
    assert_eq!(f.eval(&[0.0]), 4000.0 * 3999.0 / 2.0 + 2000.0);
}

#[test]
fn many_registers_and_branches_need_a_large_frame() {
    // All products are wanted at the end as well, so none of their registers is free before it.
    let product = |k: i32| binary(BinaryOp::Mul, Expr::Slot(0), Expr::Const(f64::from(k) + 0.5));
    let add = |a, b| binary(BinaryOp::Add, a, b);
    let chosen =
        |k: i32| Expr::Call(Builtin::Select, vec![Expr::Slot(1), product(k), add(product(k), product(0))]);
    let all = (0..600).map(product).reduce(add).expect("terms");
    let all = (0..20).map(chosen).fold(all, add);
    let [plain, native] = both(2, (0..600).rev().map(product).fold(all, add));
    for p in [[2.0, -1.0], [2.0, 1.0], [-0.3, 0.0]] {
        assert!(same(plain.eval(&p), native.eval(&p)), "{p:?}");
    }
}
