//! Internal functions against values that POV-Ray 3.7 printed.
use raggio_function::{Expr, Function, Internal};

fn internal(n: u8) -> Function {
    let params = Internal(n).params().expect("a function of this number");
    Function::new(params, Expr::Internal(Internal(n), (0..params).map(Expr::Slot).collect()))
}

#[test]
fn every_internal_function_gives_the_recorded_values() {
    let mut checked = [0; 79];
    let mut wrong = Vec::new();
    for line in include_str!("data/internals.csv").lines() {
        let mut fields = line.split(';');
        let mut field = || fields.next().expect("three fields");
        let n: u8 = field().parse().expect("a number");
        let args: Vec<f64> = field().split(',').map(|v| v.parse().expect("an argument")).collect();
        let expected: f64 = field().parse().expect("a value");
        let value = internal(n).eval(&args);
        if (value - expected).abs() > 1e-9 * expected.abs().max(1.0) {
            wrong.push(format!("{n} {:?} {args:?}: {value} instead of {expected}", Internal(n).name()));
        }
        checked[usize::from(n)] += 1;
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for (n, count) in checked.iter().enumerate() {
        assert_eq!(*count, if n == 77 { 0 } else { 5 }, "samples of internal({n})");
    }
}

#[test]
fn the_values_of_the_specification_hold() {
    let cases: [(u8, &[f64], f64); 10] = [
        (25, &[1., 0.2, 0.3, 2., 3., 0.1, 1., 1., 2., 30.], 0.2254480231),
        (23, &[0.5, 0.2, 0.7, 1.], 0.022268),
        (18, &[1., 0.5, 0.7, 1.], 0.5082437103),
        (68, &[0.3, 0.4, 0.5, 0.5, 0.7], 0.4050670032),
        (0, &[0.3, 0.4, 0.5, 1., 10., 1., 0.2, 30.], 0.2743231459),
        (24, &[1., 0.2, 0.3, 1., 3., 0.4, 0.3, 0.1, 0.2, 1., 2., 0.2, 0.1], 0.6041204353),
        (76, &[0.3, 0.4, 0.5], 0.4758712669),
        (59, &[0.3, 0.4, 0.5, 0.9, 2., 4., 0.9, 1.5, 2.], 1.0798476047),
        (29, &[0.3, 0.4, 0.5, 0.9, 2., 4., 0.9, 0.5, 2.], 1.8621231442),
        (58, &[0.3, 0.4, 0.5, 2., 4.5, 0.5, 0.5, 0.3, 2.], -0.3646161005),
    ];
    for (n, args, expected) in cases {
        let value = internal(n).eval(args);
        assert!((value - expected).abs() < 1e-8, "internal({n}): {value} instead of {expected}");
    }
}

#[test]
fn noise_follows_the_scenes_generator() {
    let args = || (0..3).map(Expr::Slot).collect();
    let old = Function::with_noise_generator(3, Expr::Internal(Internal::NOISE, args()), 1);
    assert!((old.eval(&[0.3, 0.4, 0.5]) - 0.4190316956).abs() < 1e-8);
}

#[test]
fn a_generator_below_one_is_the_first() {
    let recorded = [
        (-1.0, 0.678075305, 2.377956088),
        (-0.5, 0.419031696, 3.332765493),
        (0.1, 0.419031696, 3.332765493),
        (2.9, 0.475871267, 1.165038838),
        (4.0, 0.419031696, 3.332765493),
    ];
    for (generator, noise, ridged) in recorded {
        let found = internal(78).eval(&[0.3, 0.4, 0.5, generator]);
        assert!((found - noise).abs() < 1e-8, "{generator}: {found}");
        let found = internal(59).eval(&[0.3, 0.4, 0.5, 0.5, 2.0, 9.0, -0.7, 0.8, generator]);
        assert!((found - ridged).abs() < 1e-8, "{generator}: {found}");
    }
}

#[test]
fn unknown_numbers_have_no_parameters() {
    assert_eq!(Internal(77).params(), None);
    assert_eq!(Internal(79).params(), None);
    assert_eq!(Internal(24).params(), Some(13));
    assert_eq!(Internal(24).name(), Some("helical_torus"));
}
