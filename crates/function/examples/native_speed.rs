//! Nanoseconds an evaluation takes, interpreted and in native code, and what compiling takes:
//! `cargo run --release -p raggio-function --features native --example native_speed`.
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use raggio_function::{BinaryOp, Builtin, Expr, Function, Internal};

/// Fewer than bring native code by themselves.
const POINTS: u32 = 3000;
/// The best of so many counts.
const TIMES: u32 = 200;

fn main() {
    println!("{:24}{:>12}{:>10}{:>10}{:>14}", "", "interpreted", "native", "ratio", "compiling");
    for (name, body) in functions() {
        let best = |f: &dyn Fn() -> f64| (0..TIMES).map(|_| f()).fold(f64::MAX, f64::min);
        let plain = best(&|| speed(&Function::new(3, body.clone())));
        let function = Function::new(3, body.clone());
        let start = Instant::now();
        let there = function.prepare();
        let compiling = start.elapsed().as_secs_f64() * 1e6;
        let native = best(&|| speed(&function));
        let mark = if there { "" } else { " (no native code)" };
        println!("{name:24}{plain:9.1} ns{native:7.1} ns{:10.2}{compiling:11.0} us{mark}", plain / native);
    }
}

/// Nanoseconds an evaluation takes, over points of a line.
fn speed(f: &Function) -> f64 {
    let start = Instant::now();
    let mut sum = 0.0;
    for k in 0..POINTS {
        let t = f64::from(k) / f64::from(POINTS);
        sum += f.eval(&[t, 1.3 - t, 0.4 * t + 0.1]);
    }
    black_box(sum);
    start.elapsed().as_secs_f64() * 1e9 / f64::from(POINTS)
}

fn slot(n: usize) -> Expr {
    Expr::Slot(n)
}

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    Expr::Binary(op, Box::new(a), Box::new(b))
}

fn sum(terms: impl IntoIterator<Item = Expr>) -> Expr {
    terms.into_iter().reduce(|a, b| binary(BinaryOp::Add, a, b)).unwrap_or(Expr::Const(0.0))
}

fn times(k: f64, e: Expr) -> Expr {
    binary(BinaryOp::Mul, Expr::Const(k), e)
}

fn call(f: Builtin, args: impl Into<Vec<Expr>>) -> Expr {
    Expr::Call(f, args.into())
}

fn internal(n: u8, point: [Expr; 3], parameters: &[f64]) -> Expr {
    Expr::Internal(Internal(n), point.into_iter().chain(parameters.iter().map(|&p| Expr::Const(p))).collect())
}

/// Functions as scenes have them.
fn functions() -> Vec<(&'static str, Expr)> {
    let square = |n| call(Builtin::Sqr, [slot(n)]);
    let power = |n, k| call(Builtin::Pow, [slot(n), Expr::Const(k)]);
    let here = || [slot(0), slot(1), slot(2)];
    let sphere = binary(BinaryOp::Sub, call(Builtin::Sqrt, [sum([0, 1, 2].map(square))]), Expr::Const(1.0));
    let quartic =
        sum([0, 1, 2].map(power4(&power)).into_iter().chain([0, 1, 2].map(|n| times(-1.9, power(n, 2.0)))));
    let scaled = |k: f64| here().map(|e| times(k, e));
    let ripple =
        binary(BinaryOp::Add, sphere.clone(), times(0.1, call(Builtin::Sin, [times(20.0, slot(0))])));
    let gyroid = sum([(0, 1), (1, 2), (2, 0)]
        .map(|(a, b)| binary(BinaryOp::Mul, call(Builtin::Cos, [slot(a)]), call(Builtin::Sin, [slot(b)]))));
    let noisy = binary(BinaryOp::Sub, sphere.clone(), times(0.3, internal(76, scaled(4.0), &[])));
    let rounded = call(Builtin::Max, [sphere.clone(), times(-1.0, call(Builtin::Abs, [slot(1)])), slot(2)]);
    let branches = call(Builtin::Select, [slot(0), sphere.clone(), quartic.clone()]);
    let tall = Arc::new(Function::new(3, quartic.clone()));
    let opened =
        sum((0..4).map(|k| Expr::User(Arc::clone(&tall), scaled(0.5 + 0.25 * f64::from(k)).to_vec())));
    let waves = Expr::Loop {
        product: false,
        slot: 3,
        from: Box::new(Expr::Const(1.0)),
        to: Box::new(Expr::Const(8.0)),
        body: Box::new(binary(
            BinaryOp::Div,
            call(Builtin::Abs, [binary(BinaryOp::Mul, slot(0), slot(3))]),
            slot(3),
        )),
    };
    vec![
        ("sphere", sphere),
        ("quartic", quartic),
        ("max of three", rounded),
        ("select", branches),
        ("four quartics", opened),
        ("sum of eight", waves),
        ("sphere + sine", ripple),
        ("gyroid", gyroid),
        ("sphere - f_noise3d", noisy),
        ("f_torus", internal(70, here(), &[0.8, 0.3])),
        ("f_helix1", internal(25, here(), &[1.0, 12.0, 0.1, 0.6, 2.0, 1.0, 0.0])),
        ("f_ridged_mf", internal(59, here(), &[0.9, 2.0, 6.0, 0.9, 1.5, 2.0])),
    ]
}

fn power4(power: &impl Fn(usize, f64) -> Expr) -> impl Fn(usize) -> Expr {
    move |n| power(n, 4.0)
}
