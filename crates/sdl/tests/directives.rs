//! Directives, scope, arrays, macros and files (language spec, section 1).
mod common;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use common::{Memory, debug, debug_files, run, run_with};
use raggio_scene::{Curve, GammaMode};
use raggio_sdl::{Declared, ParseOptions};

/// The error's code and, where it matters, its place.
#[track_caller]
fn fails(text: &str, code: &str) {
    let run = run(text);
    assert_eq!(run.error(), code, "{text}: {:?}", run.diagnostics);
}

/// A macro that says a number.
const SAY: &str = "#macro Say(N) #debug concat(str(N,0,0), \" \") #end\n";

#[track_caller]
fn says(text: &str, expected: &str) {
    assert_eq!(debug(&format!("{SAY}{text}")).trim_end(), expected, "{text}");
}

#[test]
fn conditionals_stand_anywhere() {
    says("#if(1) Say(1) #else Say(2) #end", "1");
    says("#if(0) Say(1) #elseif(0) Say(2) #elseif(1) Say(3) #else Say(4) #end", "3");
    says("#if(1e-11) Say(1) #else Say(2) #end", "2");
    says("#if(0) #if(1) Say(1) #else Say(2) #end #else Say(3) #end", "3");
    says("Say(<5, #if(1) 6 #else 7 #end>.y)", "6");
    says("Say((5 #if(1) +1 #end))", "6");
    says("#ifdef(Foo) Say(1) #else Say(2) #end #ifndef(Foo) Say(3) #end", "2 3");
    says("#ifdef(sphere) Say(1) #end #ifdef(Say) Say(2) #end", "2");
    says("# if (1) Say(1) # end", "1");
    says("#declare A = 3 #if(1) + 4 #end; Say(A)", "7");
    says("#declare A = #if(0) merge #else union #end { sphere { 0, 1 } } Say(3)", "3");
    says("#declare A = pigment #declare N = 2; { rgb N } Say(N)", "2");
    fails("#if(1)", "missing-end");
    fails("#if(0)", "missing-end");
    fails("#if(0) #end #end", "unexpected-directive");
    fails("#else", "unexpected-directive");
    fails("#if(x) #end", "wrong-size");
    fails("#foo", "unknown-directive");
    says("#declare P = 3; Say(# P) # Say(#-4) #", "3 -4");
    says("# # Say(# 5)", "5");
}

#[test]
fn loops() {
    says("#declare I=0; #while(I<3) Say(I) #declare I=I+1; #end", "0 1 2");
    says("#for(I,1,3) Say(I) #end Say(I)", "1 2 3 4");
    says("#for(I,3,1,-1) Say(I) #end Say(I)", "3 2 1 0");
    says("#for(I,1,0) Say(9) #end Say(I)", "1");
    says("#for(I,0,10,2) Say(I) #if(I=4) #break #end #end Say(I)", "0 2 4 4");
    says("#for(I,0,5) Say(I) #declare I=I+1; #end", "0 2 4");
    says("#for(I,1,2) #for(J,1,2) Say(I*10+J) #end #end", "11 12 21 22");
    says("#declare I=0; #while(1) #declare I=I+1; #if(I>3) #break #end #end Say(I)", "4");
    says("#declare I=0; #declare A=(0 #while(I<3) +I #declare I=I+1; #end); Say(A)", "3");
    says("#while(0) Say(1) #end Say(2)", "2");
    fails("#for(I,1,3,0) #end", "zero-step");
    fails("#while(1) ", "missing-end");
    fails("#break", "unexpected-directive");
    fails("#for(sphere,1,2) #end", "reserved-word");
}

#[test]
fn switches() {
    let text = "#macro T(A) #switch(A) #case(1) Say(1) #case(2) Say(2) #break #range(3,5) Say(3) #else Say(4) #end \
                #debug \"|\" #end T(1) T(2) T(3) T(9)";
    says(text, "1 2 |2 |3 4 |4 |");
    says("#switch(2) #case(1) Say(1) #break #end Say(9)", "9");
    fails("#switch(2) Say(1) #case(1) #end", "switch-case");
    fails("#switch(2) #case(1)", "missing-end");
}

#[test]
fn names_follow_dynamic_scope() {
    says("#declare A=1; #macro M() #declare A=2; #end M() Say(A)", "2");
    says("#declare A=1; #macro M() #local A=2; Say(A) #end M() Say(A)", "2 1");
    says(
        "#macro Inner() Say(L) #declare L=7; #end #macro Outer() #local L=5; Inner() Say(L) #end Outer()",
        "5 7",
    );
    says("#declare A=1; #declare A=A+1; Say(A)", "2");
    says("#declare A=1; #macro M() #local A=A; #declare A=A+1; Say(A) #end M() Say(A)", "2 1");
    says("#macro M() #declare G=3; #end M() Say(G)", "3");
    says("#if(1) #local A=4; #end Say(A)", "4");
    says("#declare A=1; #declare A=\"x\"; #debug A", "x");
    says("#declare A=1; #undef A #ifdef(A) Say(1) #else Say(2) #end", "2");
    assert!(run("#undef Foo").warned("unknown-identifier"));
    fails("#macro M() #local A=1; #end M() #debug str(A,0,0)", "unknown-identifier");
    fails("#declare sphere = 1;", "reserved-word");
    fails("#macro M() #end #declare M = 1;", "macro-name");
    fails("#declare M = 1; #macro M() #end", "macro-name");
    fails("#declare A = 1 #declare B = 2;", "missing-semicolon");
    fails("#declare A = B;", "unknown-identifier");
}

#[test]
fn a_missing_semicolon_is_shown_where_it_is_missing() {
    for text in ["\n\n#declare B = 2;", "\n#while (A < 3) #end", "\n#if (A) #end", "\n#debug \"\""] {
        let ran = run(&format!("\n#declare A = 1{text}"));
        assert_eq!((ran.error(), ran.place()), ("missing-semicolon", (2, 10)), "{text}");
    }
    fails("#declare A = A;", "unknown-identifier");
    fails("#declare A = 1 #if (Other) #end", "unknown-identifier");
}

#[test]
fn one_semicolon_too_many_after_a_number_is_forgiven() {
    says("#declare A = 1;; Say(A)", "1");
    says("#declare A = <1, 2, 3>; ; Say(A.y)", "2");
    fails("#declare A = 1;;;", "unexpected");
    fails("#declare A = \"text\";;", "unexpected");
}

#[test]
fn old_declarations_need_no_semicolon() {
    says("#version 3.1; #declare A = 1\n#declare B = A+1\nSay(B)", "2");
    says(
        "#version 3.0; #declare C = color red 1 green .5\n #declare D = C red .25\n #version 3.5; Say(D.red*4+D.green*2)",
        "2",
    );
    assert!(run("#version 3.1; #declare A = 1 #declare B = 2;").warned("missing-semicolon"));
    assert!(run("declare A = 1;").warned("missing-hash"));
}

#[test]
fn deprecated_names_warn() {
    assert!(run("#declare deprecated \"use B\" A = 1; #declare C = A;").warned("deprecated"));
    let run = run("#declare deprecated once \"use B\" A = 1; #declare C = A; #declare C = A;");
    assert_eq!(run.diagnostics.iter().filter(|d| d.message == "use B").count(), 1);
}

#[test]
fn arrays() {
    says("#declare A = array[3]{1,2,3} Say(A[0]+A[1]*10+A[2]*100)", "321");
    says("#declare A = array[2][2]{{1,2}{3,4}} Say(A[1][0])", "3");
    says("#declare A = array[2]; #declare A[1]=5; Say(A[1]) Say(defined(A[0])) Say(defined(A[1]))", "5 0 1");
    says("#declare A = array[2]{1,2} #declare B = A; #declare B[0]=9; Say(A[0]) Say(B[0])", "1 9");
    says("#macro M(P) #declare P[0]=7; #end #declare A = array[1]{1} M(A) Say(A[0])", "7");
    says(
        "#declare A = array[4][2]; Say(dimensions(A)) Say(dimension_size(A,1)) Say(dimension_size(A,3))",
        "2 4 0",
    );
    says("#declare A = array[2]; #declare A[0] = array[2]{5,6} Say(A[0][1])", "6");
    says("#declare A = array[2]{1,2} Say(A[0.9999999999999])", "2");
    says("#declare A = array[2]{1,2} #undef A[0] Say(defined(A[0]))", "0");
    says("#declare A = array[2]{\"a\" \"b\"} #debug A[1]", "b");
    says("#declare A = array[1]{rgb 1} Say(A[0].red)", "1");
    says("#declare A = array[2]{x,y} Say(A[1].y)", "1");
    says("#declare A = array mixed [2]{1,<3,4,5>} #declare A[0]=\"s\"; Say(A[1].y) #debug A[0]", "4 s");
    fails("#declare A = array[2]{1}", "array-items");
    fails("#declare A = array[2]{1,2,3}", "array-items");
    fails("#declare A = array[2]{1,x}", "array-type");
    fails("#declare A = array[2]{x,<1,2>}", "array-type");
    fails("#declare A = array[2]{1,2} #declare A[0]=x;", "array-type");
    fails("#declare A = array[2]{1,2} #debug str(A[2],0,0)", "array-subscript");
    fails("#declare A = array[2]{1,2} #debug str(A[-1],0,0)", "array-subscript");
    fails("#declare A = array[2] #debug str(A[0],0,0)", "uninitialized");
    fails("#declare A = array[2][2] #debug str(A[0],0,0)", "expected");
    fails("#declare A = array[0]", "array-size");
}

#[test]
fn macros_return_text() {
    says("#macro R(A) A*2+1 #end Say(R(3)*2) Say(2*R(3))", "8 13");
    says("#macro R(A) (A*2+1) #end Say(R(3)*2) Say(R(R(1)))", "14 7");
    says("#macro Two() 2 #end Say(<1,Two(),3>.y) #debug concat(\"a\", #if(Two()=2) \"b\" #end)", "2 ab");
    says("#macro F(N) #local Q=3; Q+N #end #declare A = 1+F(1)+1; Say(A)", "6");
    says("#macro Fact(N) #if(N<2) 1 #else N*Fact(N-1) #end #end Say(Fact(5))", "120");
    says("#macro M() Say(1) #break Say(2) #end M() Say(3)", "1 3");
    says("#macro M() #for(I,1,9) #if(I=2) #break #end Say(I) #end Say(5) #end M()", "1 5");
    says("#macro A() #macro B() Say(4) #end #end A() B()", "4");
    says("#macro V(A B) Say(A) Say(B) #end V(1 2) V(<1,2>.x, 2)", "1 2 1 2");
}

#[test]
fn names_without_a_comma_between_take_the_value_of_the_second() {
    let text = "#macro P(A,B) Say(A) Say(B) #end #declare X=1; #declare Y=2; #declare Z=array[1]{3} ";
    says(&format!("{text} P(X Y)"), "2 2");
    says(&format!("{text} P(X, Y) P(X*1 Y) P((X) Y) P(X Z[0]) P(X 4)"), "1 2 1 2 1 2 1 3 1 4");
    says(&format!("{text} P(Z[0] Y)"), "2 2");
}

#[test]
fn parameters_go_by_reference_or_value() {
    says("#declare A=1; #macro M(P) #declare P=5; #end M(A) Say(A)", "5");
    says("#declare A=1; #macro M(P) #declare P=5; #end M(A+0) M((A)) M(-A) Say(A)", "1");
    says("#declare A=1; #macro M(P) #local P=5; Say(P) #end M(A) Say(A)", "5 5");
    says("#declare A=1; #macro N() #local P=5; #end #macro M(P) N() Say(P) #end M(A) Say(A)", "1 1");
    says("#declare A=array[2]{1,2} #macro M(P) #declare P=5; #end M(A[1]) Say(A[1])", "5");
    says("#declare A=1; #macro N(Q) #declare Q=Q+1; #end #macro M(P) N(P) N(P) #end M(A) Say(A)", "3");
    says("#declare A=<1,2,3>; #macro M(P) #declare P=5; #end M(A.x) Say(A.x)", "1");
    says("#macro N() #local L=4; L #end #macro M(P) Say(P) #end M(N())", "4");
    says("#macro M(P) #debug P #end M(concat(\"a\",\"b\"))", "ab");
    says(
        "#declare A=array[2]{array[1]{1},array[1]{2}} #macro M(P) #declare P[0]=8; #end M(A[1]) Say(A[1][0])",
        "8",
    );
    fails("#macro M(P) #end M(Foo)", "unknown-identifier");
    fails("#macro M(P) #end M()", "argument-count");
    fails("#macro M(P) #end M(1,2)", "argument-count");
    fails("#macro M() #end M", "expected");
    fails("#macro M(sphere) #end", "reserved-word");
    fails("#macro M(", "expected");
    fails("#macro M()", "missing-end");
}

#[test]
fn version_3_8_takes_optional_parameters_and_tuples() {
    says("#version 3.8; #macro M(A, optional B) #ifdef(B) Say(B) #else Say(A) #end #end M(1,) M(1,2)", "1 2");
    says("#version 3.8; #declare (A,B) = (1,2); Say(A) #declare (A,B) = (B,A); Say(A)", "1 2");
    assert!(run("#version 3.8;").warned("version"));
    fails("#version 3.9;", "version");
}

#[test]
fn included_files() {
    let files = Memory::with(&[
        ("a.inc", "#debug \"a\" #local L = 1; #declare G = 2;"),
        ("half.inc", "1 +"),
        ("open.inc", "#if(1) #debug \"in\""),
        ("shut.inc", "#else #debug \"not\""),
        ("macro.inc", "#macro M(A) A*2 #end"),
        ("loop.inc", "#while(1)"),
        ("scene.pov.inc", "#debug \"first\""),
        ("scene.pov", "#debug \"last\""),
        ("main.inc", "#include \"main.inc\""),
        ("dir/b.inc", "#debug \"b\""),
    ]);
    let says = |text: &str, expected: &str| assert_eq!(debug_files(text, &files), expected, "{text}");
    says("#include \"a\" #debug str(G,0,0) #ifdef(L) #debug \"L\" #end", "a2");
    says("#include concat(\"a\",\".inc\")", "a");
    says("#declare A = #include \"half.inc\" 2; #debug str(A,0,0)", "3");
    says("#include \"open.inc\" #else #debug \"x\" #end", "in");
    says("#if(0) #include \"x\" #else #debug \"y\" #end", "y");
    says("#include \"macro.inc\" #declare A = M(4)+1; #debug str(A,0,0)", "9");
    says("#include \"scene.pov\"", "first");
    says("#include \"dir\\b.inc\"", "b");
    says("#debug str(file_exists(\"a.inc\") + file_exists(\"nope\"), 0, 0)", "1");
    let error = |text: &str| run_with(text.as_bytes(), &files, &ParseOptions::default(), &Arc::default());
    assert_eq!(error("#include \"nope\"").error(), "file-not-found");
    assert_eq!(error("#include \"loop\"").error(), "missing-end");
    let endless = error("#include \"main\"");
    assert_eq!(endless.error(), "nested-too-deeply");
    assert!(endless.diagnostics[0].trace[0].what.contains("main.inc"));
}

#[test]
fn data_files_are_read() {
    let files = Memory::with(&[
        ("n.txt", "1, -2, <1,+2,3>, \"text\""),
        ("gaps", "1 2 3"),
        ("bad", "1 2 3 4,5"),
        ("comma", "1,2,"),
    ]);
    let says = |text: &str, expected: &str| assert_eq!(debug_files(text, &files), expected, "{text}");
    says(
        "#fopen F \"n.txt\" read #read(F,A,B,C,D) #debug concat(str(A+B,0,0), vstr(3,C,\"\",0,0), D, str(defined(F),0,0))",
        "-1123text0",
    );
    says("#fopen F \"gaps\" read #while(defined(F)) #read(F,A) #debug str(A,0,0) #end", "13");
    says("#fopen F \"comma\" read #while(defined(F)) #read(F,A) #debug str(A,0,0) #end", "122");
    says("#declare A=array[1]; #fopen F \"gaps\" read #read(F,A[0]) #debug str(A[0],0,0)", "1");
    let bad = "#fopen F \"bad\" read #while(defined(F)) #read(F,A) #end";
    assert_eq!(
        run_with(bad.as_bytes(), &files, &ParseOptions::default(), &Arc::default()).error(),
        "bad-data"
    );
}

#[test]
fn data_files_are_written() {
    let files = Memory::default();
    let text = "#fopen F \"t\" write #write(F, \"v=\", 1/3, x, <1,2>*.5, 1e7, (rgb 1)) #fclose F \
                #fopen F \"t\" append #write(F, \"\\n\") #fclose F";
    let text = text.replace(", (rgb 1)", "");
    debug_files(&text, &files);
    assert_eq!(files.text("t"), "v=0.333333<1,0,0> <0.5,1> 1e+07\n");
    debug_files("#fopen F \"b\" write #write(F, sint16be 258 2 (-1), uint8 300 1.5, sint32le <1,2>)", &files);
    assert_eq!(files.bytes("b"), [1, 2, 0, 2, 255, 255, 255, 2, 1, 0, 0, 0, 2, 0, 0, 0]);
    debug_files(
        "#fopen F \"i.inc\" write #write(F,\"#declare Q=5;\") #fclose F #include \"i.inc\" #debug str(Q,0,0)",
        &files,
    );
}

#[test]
fn messages_of_the_scene() {
    fails("#error \"stop here\\n\"", "scene-error");
    assert_eq!(run("#error \"stop here\\n\"").message(), "stop here");
    assert!(run("#warning \"hm\"").warned("scene-warning"));
}

#[test]
fn versions_and_gamma() {
    let settings = |text: &str| run(text).scene.expect("a scene").scene.settings;
    let bare = settings("");
    assert_eq!((bare.version.language, bare.version.effective, bare.gamma), (370, 362, GammaMode::None));
    let modern = settings("#version 3.7;");
    assert_eq!((modern.version.effective, modern.gamma), (370, GammaMode::Working(Curve::Linear)));
    let saved = settings("#declare Saved = version; #version 3.5; #version Saved;");
    assert_eq!((saved.version.effective, saved.noise_generator), (370, 2));
    let old = settings("#version 3.1;");
    assert_eq!((old.version.language, old.version.effective, old.noise_generator), (350, 310, 1));
    assert!(run("#version 3.1;").warned("old-version"));
    assert!(run("#version 3.7").warned("missing-semicolon"));
    let patch = run("#version 3.5; #version unofficial megapov 0.7;");
    assert!(patch.warned("unofficial-version"));
    assert_eq!(patch.scene.expect("a scene").scene.settings.version.language, 350);
    assert_eq!(settings("#version unofficial 3.6;").version.language, 360);
    fails("#version foo 3.5;", "unknown-identifier");
    let options = ParseOptions { version: Some(350), ..Default::default() };
    let outside =
        run_with(b"", &Memory::default(), &options, &Arc::default()).scene.expect("a scene").scene.settings;
    assert_eq!((outside.version.effective, outside.gamma), (350, GammaMode::None));
}

#[test]
fn names_from_outside() {
    let options = ParseOptions {
        declares: vec![
            ("Foo".into(), Declared::Number(1.23456789)),
            ("Bar".into(), Declared::String("b".into())),
        ],
        clock: 0.333333333333,
        clock_on: true,
        image_width: 320,
        ..Default::default()
    };
    let text = "#debug concat(str(Foo,0,8), Bar, str(clock,0,15), str(clock_on+image_width+frame_number,0,0), input_file_name)";
    let run = run_with(text.as_bytes(), &Memory::default(), &options, &Arc::default());
    assert_eq!(run.debug, "1.23457000b0.333333343267441321main.pov");
}

#[test]
fn bytes_of_any_kind_are_read() {
    let bytes = |text: &[u8]| run_with(text, &Memory::default(), &ParseOptions::default(), &Arc::default());
    assert_eq!(bytes(b"#debug \"a\" // caf\xe9\r#debug \"b\"\x1a\0").debug, "ab");
    assert_eq!(bytes(b"/* a /* nested */ \xff */ #debug \"c\"").debug, "c");
    assert_eq!(bytes(b"\xef\xbb\xbf#debug \"\xc3\xa9\"").debug, "\u{e9}");
    let ascii = bytes(b"#debug \"\xc3\xa9\"");
    assert_eq!((ascii.debug.as_str(), ascii.warned("non-ascii-string")), ("  ", true));
    assert_eq!(bytes(b"\xc3\xa9 #debug \"x\"").error(), "");
    assert_eq!(bytes(b"#debug \"x\" \xe9").error(), "illegal-character");
    assert_eq!(bytes(b"/* a").error(), "unclosed-comment");
    assert_eq!(bytes(b"#debug \"a").error(), "unclosed-string");
    assert_eq!(bytes(format!("#declare {} = 1;", "a".repeat(256)).as_bytes()).error(), "identifier-too-long");
}

#[test]
fn every_fault_is_a_diagnostic() {
    fails("#declare A = (1;", "expected");
    fails("#declare A = <1,2;", "expected");
    fails("#declare A = (1", "expected");
    fails("#declare A = <1,2", "unclosed");
    fails("#declare A = array[2]{1,", "expected");
    fails("#declare A = array[99999][99999];", "array-too-large");
    fails("#declare A = array[1e30];", "array-too-large");
    fails("#macro M() M() #end M()", "nested-too-deeply");
    fails("#macro M(A) M(A) #end M(M(1))", "nested-too-deeply");
    fails(&format!("#declare A = {}1;", "(".repeat(100_000)), "nested-too-deeply");
    fails(&format!("#declare A = {}1;", "-".repeat(100_000)), "nested-too-deeply");
    fails(&format!("#declare A = {}", "<".repeat(100_000)), "nested-too-deeply");
    fails(&format!("#declare A = {}", "array[1]{".repeat(100_000)), "nested-too-deeply");
    fails(&format!("#declare A = {}1", "1?".repeat(100_000)), "missing-semicolon");
    fails(&format!("#declare A = (1?{}", "1?".repeat(100_000)), "nested-too-deeply");
    fails("foo", "unknown-identifier");
    fails("}", "unexpected");
    fails("#declare", "expected");
    fails("#declare A", "expected");
    fails("#declare A =", "expected");
    fails("#fopen F", "expected");
    fails("#read(F, A)", "unknown-identifier");
    fails("#version", "expected");
    fails("#include 5", "expected");
    assert!(run("#").warned("stray-hash"));
}

#[test]
fn endless_loops_can_be_stopped() {
    for text in ["#while(1) #end", "#for(I,0,1e300) #declare I=0; #end", "#macro M() #end #while(1) M() #end"]
    {
        let cancel = Arc::new(AtomicBool::new(false));
        let setter = cancel.clone();
        let timer = std::thread::spawn(move || {
            std::thread::sleep(std::time::Duration::from_millis(20));
            setter.store(true, std::sync::atomic::Ordering::Relaxed);
        });
        let run = run_with(text.as_bytes(), &Memory::default(), &ParseOptions::default(), &cancel);
        timer.join().expect("the timer");
        assert_eq!(run.error(), "cancelled");
    }
}

#[test]
fn messages_name_place_way_and_remedy() {
    let run = run("#declare Radius = 1;\n#macro M()\n  #debug str(Raduis,0,0)\n#end\nM()");
    assert_eq!((run.error(), run.place()), ("unknown-identifier", (3, 14)));
    let fault = run.diagnostics.last().expect("an error");
    assert_eq!(fault.hints, ["did you mean `Radius`?"]);
    assert_eq!(fault.trace[0].what, "macro M");
    assert_eq!(run.sources.line_column(fault.trace[0].span), (5, 1));
}

/// Cut off anywhere, or with any byte replaced, a scene ends in a scene or in a diagnostic.
#[test]
fn damaged_texts_do_no_harm() {
    let text = "#version 3.7; global_settings{assumed_gamma 1 max_trace_level 5}\n#macro M(A,B) #local C=A*2; C+B #end\n\
                #declare V=array[2][2]{{1,2},{3,4}} #for(I,0,1) #declare S=concat(\"a\",str(V[I][1],3,2)); #end\n\
                #switch(2) #case(1) #debug \"x\\n\" #break #range(2,3) #debug S #else #end #undef S\n\
                #fopen F \"f\" write #write(F,1,\",\",<1,2>) #fclose F #fopen F \"f\" read #read(F,X) #fclose F\n\
                #declare P=spline{cubic_spline 0,<0,1> 1,<2,3> 2,x} #declare Q=function(x){sin(x)^2}\n\
                camera{location <0,1,-3> look_at y} light_source{<1,2,3> rgb srgb 0.5 spotlight radius 3}\n\
                union{ sphere{0,M(1,2) pigment{checker rgb 1 color red 1 scale .1}} box{-x,y rotate 30*z} }\n";
    let text = text.replace("^2", "*2").replace("rgb srgb", "srgb");
    let check = |bytes: &[u8]| {
        let run = run_with(bytes, &Memory::default(), &ParseOptions::default(), &Arc::default());
        assert_ne!(run.error(), "internal", "{}", String::from_utf8_lossy(bytes));
        run.diagnostics.iter().for_each(|d| drop((d.render(&run.sources, false), d.to_json(&run.sources))));
    };
    check(text.as_bytes());
    for at in 0..text.len() {
        check(&text.as_bytes()[..at]);
        let mut bytes = text.clone().into_bytes();
        bytes[at] = b"({<#\"})>0xA;"[at % 12];
        check(&bytes);
    }
}
