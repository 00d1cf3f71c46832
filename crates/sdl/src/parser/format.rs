//! Numbers as text, the way C prints them.

/// `%[width].[precision]f`: a negative width pads with zeros, a negative precision is 6.
pub fn fixed(x: f64, width: i64, precision: i64) -> String {
    let precision = if precision < 0 { 6 } else { precision.min(400) as usize };
    let text = if x.is_finite() { format!("{x:.precision$}") } else { not_finite(x) };
    let size = width.unsigned_abs().min(4096) as usize;
    if width >= 0 || !x.is_finite() {
        return format!("{text:>size$}");
    }
    match text.strip_prefix('-') {
        Some(digits) => format!("-{digits:0>size$}", size = size.saturating_sub(1)),
        None => format!("{text:0>size$}"),
    }
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
