//! Numbers as text, the way C prints them.
use std::fmt::Write;

/// Adds `%[width].[precision]f`: a negative width pads with zeros, a negative precision is 6.
pub fn append_fixed(out: &mut String, x: f64, width: i64, precision: i64) {
    let precision = if precision < 0 { 6 } else { precision.min(400) as usize };
    let start = out.len();
    if !x.is_finite() {
        *out += &not_finite(x);
    } else if !append_short(out, x, precision) {
        // Writing to a string can't fail.
        let _ = write!(out, "{x:.precision$}");
    }
    let size = width.unsigned_abs().min(4096) as usize;
    let missing = size.saturating_sub(out.len() - start);
    if missing == 0 {
        return;
    }
    let zeros = width < 0 && x.is_finite();
    let at = start + usize::from(zeros && out[start..].starts_with('-'));
    out.insert_str(at, &(if zeros { "0" } else { " " }).repeat(missing));
}

/// Numbers of few digits, by way of a whole number; false where that might round differently from the exact decimal
/// expansion, or where there are too many digits.
fn append_short(out: &mut String, x: f64, precision: usize) -> bool {
    const POWERS: [f64; 7] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
    let Some(&power) = POWERS.get(precision) else { return false };
    let scaled = x.abs() * power;
    let whole = scaled.round();
    // The product is off by less than 1e-6 where it is below 1e9.
    let clear = ((scaled - scaled.floor()) - 0.5).abs() > 1e-6;
    if scaled >= 1e9 || !clear {
        return false;
    }
    let (whole, power) = (whole as u64, power as u64);
    let sign = if x.is_sign_negative() { "-" } else { "" };
    let _ = match precision {
        0 => write!(out, "{sign}{whole}"),
        _ => write!(out, "{sign}{}.{:0precision$}", whole / power, whole % power),
    };
    true
}

/// `%g`: six significant digits, without trailing zeros.
pub fn general(x: f64) -> String {
    if !x.is_finite() {
        return not_finite(x);
    }
    if x == 0.0 {
        return if x.is_sign_negative() { "-0" } else { "0" }.to_owned();
    }
    let scientific = format!("{x:.5e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let places = (5 - exponent).max(0) as usize;
        return trimmed(&format!("{x:.places$}")).to_owned();
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{}e{sign}{:02}", trimmed(mantissa), exponent.abs())
}

/// A number after a way through text of six significant digits.
pub fn six_digits(x: f64) -> f64 {
    general(x).parse().unwrap_or(x)
}

fn trimmed(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

fn not_finite(x: f64) -> String {
    let sign = if x.is_sign_negative() { "-" } else { "" };
    format!("{sign}{}", if x.is_nan() { "nan" } else { "inf" })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fixed(x: f64, width: i64, precision: i64) -> String {
        let mut text = String::from("|");
        append_fixed(&mut text, x, width, precision);
        text.split_off(1)
    }

    #[test]
    fn short_numbers_agree_with_exact_ones() {
        let mut x = 1.0e-7f64;
        while x < 1e10 {
            for precision in 0..9 {
                for x in [x, -x, x.round() + 0.5, (x * 16.0).round() / 16.0, (x * 1000.0).round() / 1000.0] {
                    assert_eq!(fixed(x, 0, precision), format!("{x:.p$}", p = precision as usize));
                }
            }
            x *= 1.37;
        }
        assert_eq!(fixed(-0.0, 0, 1), "-0.0");
    }

    #[test]
    fn numbers_print_as_in_c() {
        assert_eq!(fixed(-2.71, -8, 2), "-0002.71");
        assert_eq!(fixed(2.5, 0, 0), "2");
        assert_eq!(fixed(-3.5, 6, 0), "    -4");
        assert_eq!(fixed(f64::INFINITY, -6, 1), "   inf");
        assert_eq!(general(1234567.0), "1.23457e+06");
        assert_eq!(general(0.0001), "0.0001");
        assert_eq!(general(1.5e-5), "1.5e-05");
        assert_eq!(general(999999.5), "1e+06");
        assert_eq!(general(100000.0), "100000");
    }
}
