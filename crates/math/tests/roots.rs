//! Roots against those that another program found with eighty digits.
use raggio_math::poly;

const DATA: &str = include_str!("data/roots.csv");

/// Rounding that evaluation at `x` may have suffered, in values of the polynomial.
fn noise(c: &[f64], x: f64) -> f64 {
    let size: f64 = c.iter().enumerate().map(|(k, c)| c.abs() * x.abs().powi(k as i32)).sum();
    8.0 * f64::EPSILON * size
}

fn slope(c: &[f64], x: f64) -> f64 {
    (1..c.len()).map(|k| k as f64 * c[k] * x.powi(k as i32 - 1)).sum()
}

/// Checks one polynomial; returns how many of its roots are sure.
fn check<const N: usize>(line: &str, coefficients: &[f64], expected: &[f64]) -> usize {
    let mut c = [0.0; N];
    c.copy_from_slice(coefficients);
    let found = poly::real_roots(&c);
    let mut sure = 0;
    for (i, &x) in expected.iter().enumerate() {
        let uncertain = noise(&c, x) / slope(&c, x).abs();
        let gap = expected.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, y)| (x - y).abs());
        // Two that rounding can make one need not be found.
        if uncertain > 0.1 * gap.fold(f64::INFINITY, f64::min) {
            continue;
        }
        sure += 1;
        let near = found.iter().any(|y| (x - y).abs() <= 2.0 * uncertain + 1e-13 * x.abs());
        assert!(near, "{x} is not among {:?}: {line}", &*found);
    }
    for &y in found.iter() {
        let value = poly::eval(&c, y).abs();
        let step = 1e-12 * y.abs() * slope(&c, y).abs();
        assert!(value <= noise(&c, y) + step, "{y} is no root: {line}");
    }
    sure
}

#[test]
fn roots_are_those_found_with_eighty_digits() {
    let (mut lines, mut sure) = (0, 0);
    for line in DATA.lines().filter(|l| !l.starts_with('#')) {
        let fields: Vec<&str> = line.split(';').collect();
        let numbers = |s: &str| -> Vec<f64> { s.split(',').filter_map(|x| x.parse().ok()).collect() };
        let (c, expected) = (numbers(fields[1]), numbers(fields[2]));
        sure += match c.len() {
            4 => check::<4>(line, &c, &expected),
            5 => check::<5>(line, &c, &expected),
            7 => check::<7>(line, &c, &expected),
            n => panic!("{n} coefficients"),
        };
        lines += 1;
    }
    assert!(lines == 200 && sure > 500, "{sure} roots of {lines} polynomials");
}
