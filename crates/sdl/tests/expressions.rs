//! Expressions, against values recorded from the program (language spec, section 2).
mod common;
use common::{debug, eval, run, vector};

#[track_caller]
fn gives(expression: &str, expected: f64) {
    let value = eval(expression);
    assert!(
        (value - expected).abs() <= 1e-10 * expected.abs().max(1.0),
        "{expression} = {value}, not {expected}"
    );
}

#[track_caller]
fn fails(text: &str, code: &str) {
    let run = run(text);
    assert_eq!(run.error(), code, "{text}: {:?}", run.diagnostics);
}

#[test]
fn operators_bind_as_in_the_language() {
    gives("1 + 2 * 3", 7.0);
    gives("3 > 2 > 1", 0.0);
    gives("1 | 0 & 0", 0.0);
    gives("-<1,2>.y", -2.0);
    gives("!0 + 1", 2.0);
    gives("2 * -3", -6.0);
    gives("10 / 4 / 5", 0.5);
    gives("1 ? 2 : 3", 2.0);
    gives("0 ? 2 : 0 ? 3 : 4", 4.0);
    gives("1 = 1 + 1e-11", 1.0);
    gives("1 < 1 + 1e-11", 1.0);
    gives("1 + 1e-11 <= 1", 1.0);
    gives("1 != 2", 1.0);
    gives("2 >= 2", 1.0);
    gives("1e-11 | 0", 0.0);
}

#[test]
fn numbers_are_read_as_in_the_language() {
    gives("1.", 1.0);
    gives(".5e1", 5.0);
    gives("1e", 1.0);
    gives("1E+2", 100.0);
    gives("pi", std::f64::consts::PI);
    gives("yes + true + on + no", 3.0);
    fails("#debug str(1..5,0,0)", "malformed-number");
}

#[test]
fn only_brackets_and_some_slots_take_full_expressions() {
    gives("sin(1 < 2)", 1f64.sin());
    fails("#declare B = 1 < 2;", "missing-semicolon");
    assert_eq!(vector(2, "<1 -2 3>"), [-1.0, 3.0]);
    fails("#declare A = 2 * rgb <1,0,0>;", "expected");
    assert_eq!(debug("#declare A = rgb <1,0,0>*2; #debug vstr(3, A, \",\", 0, 0)"), "2,0,0");
}

#[test]
fn sizes_are_made_equal() {
    assert_eq!(vector(3, "<1,2>*3+z"), [3.0, 6.0, 1.0]);
    assert_eq!(vector(3, "vrotate(2, 0)"), [2.0, 2.0, 2.0]);
    assert_eq!(vector(3, "7"), [7.0, 0.0, 0.0]);
    assert_eq!(vector(4, "(t)"), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(vector(2, "u + 2*v"), [1.0, 2.0]);
    assert_eq!(vector(3, "(<1,2,3> = 1)"), [1.0, 0.0, 0.0]);
    assert_eq!(vector(3, "(1 = <1,1,2>)"), [1.0, 1.0, 0.0]);
    assert_eq!(vector(3, "vrotate(<1,2>, 0)"), [1.0, 2.0, 0.0]);
    fails("#debug vstr(3, vrotate(<1,2,3,4>, 0), \"\", 0, 0)", "wrong-size");
    fails("#debug str(x, 0, 0)", "wrong-size");
    fails("#debug str(<1,2>.z, 0, 0)", "no-such-component");
    gives("<0.2,0.4,0.6>.gray", 0.297 * 0.2 + 0.589 * 0.4 + 0.114 * 0.6);
    gives("<1,2,3,4,5>.transmit", 5.0);
    gives("<1,2,3,4,5>.filter", 4.0);
}

#[test]
fn float_functions() {
    gives("int(-1.5)", -1.0);
    gives("int(3e9)", -2147483648.0);
    gives("div(-7, 2)", -3.0);
    gives("mod(-7, 2)", -1.0);
    gives("mod(7, -2.5)", 2.0);
    gives("pow(2, 0.5)", 2f64.sqrt());
    gives("log(1000)", 3.0);
    gives("ln(exp(2))", 2.0);
    gives("sqr(3) + sqrt(16)", 13.0);
    gives("min(3, 1, 2) + max(3, 1, 2)", 4.0);
    gives("select(-1, 10, 20)", 10.0);
    gives("select(0, 10, 20)", 20.0);
    gives("select(0, 10, 20, 30)", 20.0);
    gives("select(1e-20, 10, 20, 30)", 30.0);
    gives("bitwise_and(12, 10) + bitwise_or(12, 10)*100 + bitwise_xor(12, 10)*10000", 8.0 + 1400.0 + 60000.0);
    gives("degrees(pi)", 180.0);
    gives("radians(180)", std::f64::consts::PI);
    gives("atan2(1, 1)", std::f64::consts::FRAC_PI_4);
    gives("asin(2)", std::f64::consts::FRAC_PI_2);
    gives("abs(-2) + ceil(1.2) + floor(-1.2)", 2.0);
    gives(
        "tanh(1) + asinh(1) + acosh(2) + atanh(0.5)",
        1f64.tanh() + 1f64.asinh() + 2f64.acosh() + 0.5f64.atanh(),
    );
    gives("vlength(<3,4,0>) + vdot(<1,2,3>, <4,5,6>)", 37.0);
    gives("version", 3.7);
    fails("#debug str(pow(0,0),0,0)", "domain");
    fails("#debug str(atan2(0,0),0,0)", "domain");
    fails("#debug str(sqrt(-1),0,0)", "domain");
    fails("#debug str(ln(0),0,0)", "domain");
    assert!(run("#debug str(acos(1.5),0,0)").warned("domain"));
}

#[test]
fn division_by_zero_is_infinite() {
    assert_eq!(debug("#debug str(-1/0, 0, 1)"), "inf");
    assert_eq!(debug("#debug vstr(2, <1,2>/<0,2>, \",\", 0, 0)"), "inf,1");
    assert!(run("#declare A = 1/0;").warned("division-by-zero"));
}

#[test]
fn vector_functions() {
    let near = |a: Vec<f64>, b: [f64; 3]| {
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9), "{a:?} {b:?}");
    };
    near(vector(3, "vcross(x, y)"), [0.0, 0.0, 1.0]);
    near(vector(3, "vnormalize(<3,0,4>)"), [0.6, 0.0, 0.8]);
    near(vector(3, "vnormalize(0)"), [0.0, 0.0, 0.0]);
    near(vector(3, "vrotate(x, <0,90,90>)"), [0.0, 0.0, -1.0]);
    near(vector(3, "vaxis_rotate(x, y, 90)"), [0.0, 0.0, -1.0]);
}

#[test]
fn strings_print_numbers_as_c_does() {
    assert_eq!(debug("#debug str(-3.14159, -8, 2)"), "-0003.14");
    assert_eq!(debug("#debug str(2.5, 0, 0)"), "2");
    assert_eq!(debug("#debug str(-3.5, 0, 0)"), "-4");
    assert_eq!(debug("#debug str(1/3, 0, -1)"), "0.333333");
    assert_eq!(debug("#debug str(7, 4, 1)"), " 7.0");
    assert_eq!(debug("#debug vstr(9, <1,2,3>, \";\", 0, 1)"), "1.0;2.0;3.0;0.0;0.0");
}

#[test]
fn string_functions() {
    assert_eq!(debug(r#"#debug concat("a", str(1,0,0), chr(66), strupr("c"), strlwr("D"))"#), "a1BCd");
    assert_eq!(debug(r#"#debug substr("hello", 2, 3)"#), "ell");
    assert_eq!(debug(r#"#debug concat(substr("hello", 0, 6), "!")"#), "!");
    gives(r#"strcmp("abc", "abd")"#, -1.0);
    gives(r#"strcmp("b", "abc")"#, 1.0);
    gives(r#"strcmp("ab", "ab")"#, 0.0);
    gives(r#"strlen("four") + asc("A") + asc("")"#, 69.0);
    gives(r#"val(" -1.5e1xyz")"#, -15.0);
    gives(r#"val("none")"#, 0.0);
    gives(r#""abc" < "abd""#, 1.0);
    gives(r#""abc" = "abc""#, 1.0);
    gives(r#"("a" != "a") + ("b" >= "a") + ("a" > "a")"#, 1.0);
    assert_eq!(debug(r#"#declare S = "q"; #debug concat(S, S)"#), "qq");
    assert_eq!(debug(r#"#debug datetime(0)"#), "2000-01-01 00:00:00Z");
    assert_eq!(debug(r#"#debug datetime(59.75, "%d %b %y, %H:%M %a %j")"#), "29 Feb 00, 18:00 Tue 060");
    fails(r#"#debug substr("hello", 4, 3)"#, "substr-range");
    fails(r#"#debug "\q""#, "bad-escape");
    fails(r#"#debug Foo"#, "unknown-identifier");
}

#[test]
fn escapes_belong_to_text() {
    assert_eq!(debug(r#"#debug "a\n\t\"\\\u0041""#), "a\n\t\"\\A");
    assert_eq!(debug("#debug \"two\r\nlines\""), "two\nlines");
}

#[test]
fn random_streams_repeat() {
    gives("seed(5)", 0.0);
    let text = "#declare R = seed(42); #debug concat(str(rand(R),0,10), \" \", str(rand(R),0,10), \" \", str(rand(R),0,10))";
    assert_eq!(debug(text), "0.7235829112 0.3299792596 0.7557616704");
    let text = "#declare A = seed(1); #declare R = seed(0); #debug concat(str(R,0,0), str(rand(R),0,10), \" \", str(rand(R),0,10))";
    assert_eq!(debug(text), "10.0000028743 0.4665636845");
    fails("#debug str(rand(3), 0, 0)", "rand-stream");
}

#[test]
fn colours() {
    let channels = |phrase: &str| debug(&format!("#declare C = {phrase}; #debug vstr(5, C, \" \", 0, 2)"));
    assert_eq!(channels("rgb 1"), "1.00 1.00 1.00 0.00 0.00");
    assert_eq!(channels("rgbt 1"), "1.00 1.00 1.00 0.00 1.00");
    assert_eq!(channels("rgbf 0.5"), "0.50 0.50 0.50 0.50 0.00");
    assert_eq!(channels("rgbft <1,2,3,4,5>"), "1.00 2.00 3.00 4.00 5.00");
    assert_eq!(channels("color rgbt <1,2,3,4>"), "1.00 2.00 3.00 0.00 4.00");
    assert_eq!(channels("color <1,2,3>"), "1.00 2.00 3.00 0.00 0.00");
    assert_eq!(channels("color 0.5"), "0.50 0.50 0.50 0.50 0.50");
    assert_eq!(channels("colour red 1"), "1.00 0.00 0.00 0.00 0.00");
    assert_eq!(channels("red 1 blue .5 alpha .25"), "1.00 0.00 0.50 0.25 0.00");
    assert_eq!(channels("rgb <1,2,3> red 5 transmit .5"), "5.00 2.00 3.00 0.00 0.50");
    assert_eq!(channels("rgb <1,2,3,4,5>"), "1.00 2.00 3.00 4.00 5.00");
    assert_eq!(channels("rgb 1; #declare C = color C red 5"), "5.00 1.00 1.00 0.00 0.00");
    assert_eq!(channels("rgb 1; #declare C = C*2"), "2.00 2.00 2.00 0.00 0.00");
    assert!(run("#declare C = rgb <1,2,3,4,5>;").warned("suspicious-color"));
    assert_eq!(debug("#declare C = <.1,0,0,0,0>; #debug str(C.red, 0, 12)"), "0.100000001490");
    fails("#declare C = srgb 0.5;", "srgb-without-gamma");
    fails("#declare C = rgb 1; #declare D = C red 7;", "missing-semicolon");
}

#[test]
fn splines() {
    let s = |points: &str, call: &str| {
        debug(&format!(
            "#declare S = spline {{ {points} }} #declare V = {call}; #debug vstr(2, V, \" \", 0, 6)"
        ))
    };
    assert_eq!(s("0, <0,1>, 1, <2,3>", "S(0.5)"), "1.000000 2.000000");
    assert_eq!(s("linear_spline 1, 5 0, 1", "S(0.25)"), "2.000000 2.000000");
    assert_eq!(s("quadratic_spline 0,0 1,1 2,4 3,9", "S(2.5)"), "6.250000 6.250000");
    assert_eq!(s("quadratic_spline 0,0 1,1 2,4 3,0", "S(0.5)"), "0.250000 0.250000");
    assert_eq!(s("cubic_spline 0,0 1,1 2,2 3,3", "S(1.5)"), "1.500000 1.500000");
    assert_eq!(s("cubic_spline 0,0 1,1 2,2 3,3", "S(0.5)"), "1.000000 1.000000");
    assert_eq!(s("cubic_spline 0,0 1,4", "S(9)"), "2.000000 2.000000");
    assert_eq!(s("natural_spline 0,0 1,1 2,0", "S(0.5)"), "0.687500 0.687500");
    assert_eq!(s("natural_spline 0,0 1,1 2,0", "S(0.5, linear_spline)"), "0.500000 0.500000");
    assert_eq!(s("0,0 1,1 1,7", "S(1)"), "1.000000 1.000000");
    assert_eq!(s("0,0 1,1 0,7", "S(0)"), "7.000000 7.000000");
    assert_eq!(s("0,0 1,1", "S(5)"), "1.000000 1.000000");
    fails("#declare S = spline { linear_spline }", "empty-spline");
}

/// Expressions in loops become trees on their second visit; the tree must say what the walk says.
#[test]
fn repeated_expressions_keep_their_values() {
    let expressions = [
        "1 + 2*I - 3/(I+1)",
        "(I > 1 & I < 3 | I = 0)",
        "<I, 2, -I>*2 + x",
        "-<I,2>.y + V.z*A[I]",
        "(I ? 5 : <1,2,3>)",
        "sin(I) + sqrt(I) + mod(I,2) + pow(I+1,2) + min(I,1,2) + select(I-1,1,2,3)",
        "vlength(V) + vdot(V,x) + vrotate(V,<I,0,0>).y + vcross(V,y).z",
        "rand(R)",
        "rand(R)*<1,2,3>",
        "B[I][1].y + !I",
        "1/(I-1)",
        "S(I/2)",
        "M(I)",
    ];
    for expression in expressions {
        let names = "#declare R=seed(3); #declare V=<1,2,3>; #declare A=array[4]{1,2,3,4} \
                     #declare B=array[4][2]{{x,y}{x,y}{x,2*y}{x,y}} #declare S=spline{0,0 1,1 2,4} #macro M(Q) Q*2+1 #end\n";
        let say = |i: &str| {
            format!("#declare I={i}; #declare W={expression}; #debug vstr(3,W*1,\" \",0,9) #debug \"|\"\n")
        };
        let unrolled: String = (0..4).map(|i| say(&i.to_string())).collect();
        let looped = format!("#for(K,0,3)\n{}#end", say("K"));
        assert_eq!(debug(&format!("{names}{looped}")), debug(&format!("{names}{unrolled}")), "{expression}");
    }
}
