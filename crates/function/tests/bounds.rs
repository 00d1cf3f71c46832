//! Bounds hold all values and all difference quotients of a function.
use proptest::prelude::*;
use raggio_function::{BinaryOp, Bounds, Builtin, Expr, Function, Internal, Range};

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    Expr::Binary(op, Box::new(a), Box::new(b))
}

/// Small expressions of x, y and z with all that bounds have rules for.
fn expression() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![
        3 => (0usize..3).prop_map(Expr::Slot),
        1 => (-3.0..3.0f64).prop_map(Expr::Const),
        1 => (-3i32..4).prop_map(|n| Expr::Const(f64::from(n))),
    ];
    leaf.prop_recursive(5, 24, 2, |inner| {
        use BinaryOp::*;
        use Builtin::*;
        let operator = prop::sample::select(vec![Add, Sub, BinaryOp::Mul, BinaryOp::Div, Lt, Ge]);
        let one = prop::sample::select(vec![
            Abs, Sqrt, Sqr, Sin, Cos, Tan, Exp, Ln, Atan, Tanh, Sinh, Floor, Ceil, Radians, Acos,
        ]);
        let two = prop::sample::select(vec![Min, Max, Atan2, Mod, Pow]);
        prop_oneof![
            (operator, inner.clone(), inner.clone()).prop_map(|(op, a, b)| binary(op, a, b)),
            (one, inner.clone()).prop_map(|(f, a)| Expr::Call(f, vec![a])),
            (two, inner.clone(), inner.clone()).prop_map(|(f, a, b)| Expr::Call(f, vec![a, b])),
            (inner.clone(), inner.clone())
                .prop_map(|(a, b)| Expr::Call(Select, vec![a, b, Expr::Const(0.5)])),
            // Whole multiples of an azimuth under a sine have no seam.
            (inner.clone(), inner.clone(), 1i32..9).prop_map(|(a, b, n)| {
                let angle = Expr::Call(Atan2, vec![a, b]);
                Expr::Call(Sin, vec![binary(BinaryOp::Mul, angle, Expr::Const(f64::from(n)))])
            }),
        ]
    })
}

/// Is `v` in the range, but for rounding?
fn holds(range: Range, v: f64) -> bool {
    let slack = 1e-9 * (1.0 + v.abs() + if range.is_all() { 0.0 } else { range.size().min(1e300) });
    range.lo - slack <= v && v <= range.hi + slack
}

/// Checks a function over a box at points given as shares of the box.
fn check(f: &Function, low: [f64; 3], size: [f64; 3], shares: &[[f64; 3]]) -> Result<(), TestCaseError> {
    let args: Vec<Bounds> =
        (0..3).map(|k| Bounds::variable(k, Range::new(low[k], low[k] + size[k]))).collect();
    let bounds = f.enclose(&args);
    if !bounds.value.size().is_finite() {
        return Ok(());
    }
    for share in shares {
        let p: [f64; 3] = std::array::from_fn(|k| low[k] + share[k] * size[k]);
        let here = f.eval(&p);
        prop_assert!(holds(bounds.value, here), "{here} is outside {bounds:?} at {p:?}");
        for k in 0..3 {
            let mut q = p;
            q[k] = low[k] + shares[0][k] * size[k];
            if (q[k] - p[k]).abs() < 1e-3 * size[k] {
                continue;
            }
            let slope = (f.eval(&q) - here) / (q[k] - p[k]);
            prop_assert!(holds(bounds.slopes[k], slope), "slope {slope} along {k} is outside {bounds:?}");
        }
    }
    Ok(())
}

fn shares() -> impl Strategy<Value = Vec<[f64; 3]>> {
    prop::collection::vec(prop::array::uniform3(0.0..=1.0f64), 12)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]
    #[test]
    fn expressions_stay_within_their_bounds(
        e in expression(),
        low in prop::array::uniform3(-3.0..3.0f64),
        size in prop::array::uniform3(0.01..1.5f64),
        shares in shares(),
    ) {
        check(&Function::new(3, e), low, size, &shares)?;
    }

    #[test]
    fn internal_functions_stay_within_their_bounds(
        n in 0u8..79,
        parameters in prop::array::uniform10(0.2..2.0f64),
        low in prop::array::uniform3(-2.0..2.0f64),
        size in prop::array::uniform3(0.01..0.5f64),
        shares in shares(),
    ) {
        prop_assume!(Internal(n).params().is_some());
        let mut args: Vec<Expr> = (0..3).map(Expr::Slot).collect();
        args.extend(parameters.map(Expr::Const));
        check(&Function::new(3, Expr::Internal(Internal(n), args)), low, size, &shares)?;
    }

    #[test]
    fn noise_stays_within_its_bounds(
        generator in 1u8..4,
        low in prop::array::uniform3(-40.0..40.0f64),
        size in prop::array::uniform3(0.01..0.3f64),
        shares in shares(),
    ) {
        let args = (0..3).map(Expr::Slot).collect();
        let f = Function::with_noise_generator(3, Expr::Internal(Internal(76), args), generator);
        check(&f, low, size, &shares)?;
    }
}

#[test]
fn functions_are_the_same_if_they_compute_the_same() {
    let scaled = |k: f64| Function::new(2, binary(BinaryOp::Mul, Expr::Slot(0), Expr::Const(k)));
    assert!(scaled(2.0).same(&scaled(2.0)));
    assert!(!scaled(2.0).same(&scaled(3.0)));
    assert!(!scaled(2.0).same(&Function::new(2, Expr::Slot(0))));
}

#[test]
fn slopes_of_a_length_are_known_around_its_axis() {
    // A box around a rounded box's face: the function is the distance from a plane there, less the radius.
    let mut args: Vec<Expr> = (0..3).map(Expr::Slot).collect();
    args.extend([0.3, 1.5, 1.5, 1.5].map(Expr::Const));
    let names = (0..79).map(Internal).find(|i| i.name() == Some("rounded_box"));
    let f = Function::new(3, Expr::Internal(names.expect("a rounded box"), args));
    let place = [(1.3, 1.4), (-0.1, 0.1), (-0.1, 0.1)];
    let bounds = f.enclose(&std::array::from_fn::<_, 3, _>(|k| {
        Bounds::variable(k, Range::new(place[k].0, place[k].1))
    }));
    assert_eq!(bounds.slopes[0], Range::new(1.0, 1.0));
    assert_eq!(bounds.slopes[1], Range::new(0.0, 0.0));
}

#[test]
fn bounds_are_tight_where_nothing_depends() {
    let product = Function::new(2, binary(BinaryOp::Mul, Expr::Slot(0), Expr::Slot(1)));
    let bounds = product
        .enclose(&[Bounds::variable(0, Range::new(1.0, 2.0)), Bounds::variable(1, Range::new(-3.0, 4.0))]);
    assert_eq!(bounds.value, Range::new(-6.0, 8.0));
    assert_eq!(bounds.slopes[0], Range::new(-3.0, 4.0));
    assert_eq!(bounds.slopes[1], Range::new(1.0, 2.0));
}
