//! A very small reader of pattern statements, just enough for the recorded samples.
pub mod pictures;

use std::iter::Peekable;
use std::sync::Arc;

use raggio_function::{BinaryOp, Expr, Function};
use raggio_math::{Affine, Vec2, Vec3, transform};
use raggio_scene::{
    Color, CrackleSettings, FractalKind, FractalSettings, ImageMap, Interpolation, MapType, Object,
    ObjectKind, Pattern, PatternKind, Pigment, PigmentKind, Shape, Turbulence, Warp, Wave,
};

/// Reads a statement as it stands inside `pattern { ... }`.
pub fn pattern(text: &str) -> Pattern {
    let mut reader = Reader { tokens: tokens(text).into_iter().peekable() };
    let pattern = reader.pattern();
    assert!(reader.tokens.next().is_none(), "{text}");
    pattern
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Word(String),
    Number(f64),
    Text(String),
    Mark(char),
}

fn tokens(text: &str) -> Vec<Token> {
    let chars: Vec<char> = text.chars().collect();
    let (mut out, mut i) = (Vec::new(), 0);
    while i < chars.len() {
        let start = i;
        let mut run = |keep: &dyn Fn(char) -> bool| {
            i += 1;
            while i < chars.len() && keep(chars[i]) {
                i += 1;
            }
            chars[start..i].iter().collect::<String>()
        };
        match chars[start] {
            ' ' => i += 1,
            '"' => {
                let body = run(&|c| c != '"');
                i += 1;
                out.push(Token::Text(body[1..].to_string()));
            }
            c if c.is_alphabetic() => {
                let word = run(&|c| c.is_alphanumeric() || c == '_');
                out.push(Token::Word(word));
            }
            c if c.is_ascii_digit() || c == '.' => {
                let number = run(&|c| c.is_ascii_digit() || c == '.');
                out.push(Token::Number(number.parse().expect("a number")));
            }
            c => {
                i += 1;
                out.push(Token::Mark(c));
            }
        }
    }
    out
}

struct Reader {
    tokens: Peekable<std::vec::IntoIter<Token>>,
}

impl Reader {
    fn word(&mut self) -> String {
        match self.tokens.next() {
            Some(Token::Word(word)) => word,
            other => panic!("a word, not {other:?}"),
        }
    }

    fn text(&mut self) -> String {
        match self.tokens.next() {
            Some(Token::Text(text)) => text,
            other => panic!("a string, not {other:?}"),
        }
    }

    fn skip(&mut self, mark: char) -> bool {
        self.tokens.next_if_eq(&Token::Mark(mark)).is_some()
    }

    fn skip_word(&mut self, word: &str) -> bool {
        self.tokens.next_if_eq(&Token::Word(word.into())).is_some()
    }

    fn number(&mut self) -> f64 {
        let sign = if self.skip('-') { -1.0 } else { 1.0 };
        match self.tokens.next() {
            Some(Token::Number(number)) => {
                self.skip(',');
                sign * number
            }
            other => panic!("a number, not {other:?}"),
        }
    }

    /// A vector, an axis, a number, or a number times an axis.
    fn vector(&mut self) -> Vec3 {
        if self.skip('<') {
            let mut v = Vec3::ZERO;
            let mut k = 0;
            while !self.skip('>') {
                v[k] = self.number();
                k += 1;
            }
            self.skip(',');
            return v;
        }
        let axis = ['x', 'y', 'z'].iter().position(|c| self.skip_word(&c.to_string()));
        if let Some(axis) = axis {
            self.skip(',');
            return Vec3::AXES[axis];
        }
        let number = self.number();
        if self.skip('*') { number * self.vector() } else { Vec3::splat(number) }
    }

    fn pattern(&mut self) -> Pattern {
        let word = self.word();
        let kind = self.kind(&word);
        let triangle = ["marble", "wood", "spiral1", "spiral2"].contains(&word.as_str());
        let flat = ["checker", "object", "brick", "hexagon", "square", "triangular", "cubic", "quilted"];
        let still = flat.contains(&word.as_str()) || word == "image_pattern";
        let mut pattern = Pattern {
            kind,
            warps: Vec::new(),
            wave: if triangle { Wave::Triangle } else { Wave::Ramp },
            frequency: if still { 0.0 } else { 1.0 },
            phase: 0.0,
            noise_generator: 0,
        };
        while let Some(Token::Word(word)) = self.tokens.next_if(|t| matches!(t, Token::Word(_))) {
            self.modifier(&word, &mut pattern);
        }
        pattern
    }

    fn kind(&mut self, word: &str) -> PatternKind {
        match word {
            "bozo" | "bumps" | "spotted" => PatternKind::Bozo,
            "granite" => PatternKind::Granite,
            "wrinkles" => PatternKind::Wrinkles,
            "dents" => PatternKind::Dents,
            "agate" => PatternKind::Agate { turbulence: 1.0 },
            "marble" => PatternKind::Marble,
            "boxed" => PatternKind::Boxed,
            "brick" => PatternKind::Brick { size: Vec3::new(8.0, 3.0, 4.5), mortar: 0.5 },
            "cells" => PatternKind::Cells,
            "checker" => PatternKind::Checker,
            "crackle" => PatternKind::Crackle(CrackleSettings::default()),
            "cubic" => PatternKind::Cubic,
            "cylindrical" => PatternKind::Cylindrical,
            "planar" => PatternKind::Planar,
            "spherical" => PatternKind::Spherical,
            "gradient" => PatternKind::Gradient(self.vector()),
            "hexagon" => PatternKind::Hexagon,
            "leopard" => PatternKind::Leopard,
            "onion" => PatternKind::Onion,
            "quilted" => PatternKind::Quilted { control0: 1.0, control1: 1.0 },
            "radial" => PatternKind::Radial,
            "ripples" => PatternKind::Ripples,
            "waves" => PatternKind::Waves,
            "spiral1" => PatternKind::Spiral1(self.number() as i32),
            "spiral2" => PatternKind::Spiral2(self.number() as i32),
            "square" => PatternKind::Square,
            "triangular" => PatternKind::Triangular,
            "wood" => PatternKind::Wood,
            "tiling" => PatternKind::Tiling(self.number() as u8),
            "pavement" => {
                PatternKind::Pavement { sides: 3, tiles: 1, pattern: 1, exterior: 0, interior: 0, form: 0 }
            }
            "mandel" | "julia" | "magnet" => self.fractal(word),
            "density_file" => {
                self.word();
                PatternKind::DensityFile(Arc::new(pictures::density(&self.text())))
            }
            "function" => self.function(),
            "pigment_pattern" => self.pigment_pattern(),
            "object" => self.object(),
            "image_pattern" => self.image(),
            other => panic!("no pattern {other}"),
        }
    }

    fn fractal(&mut self, word: &str) -> PatternKind {
        let mut kind = FractalKind::Power(2);
        let mut form = word.to_string();
        if word == "magnet" {
            kind = if self.number() == 1.0 { FractalKind::Magnet1 } else { FractalKind::Magnet2 };
            form = self.word();
        }
        let julia = (form == "julia").then(|| self.vector()).map(|v| Vec2::new(v.x, v.y));
        PatternKind::Fractal(FractalSettings {
            kind,
            julia,
            iterations: self.number() as u32,
            exterior_type: 1,
            exterior_factor: 1.0,
            interior_type: 0,
            interior_factor: 1.0,
        })
    }

    /// Only the two function bodies that the samples use.
    fn function(&mut self) -> PatternKind {
        let body: Vec<Token> = self.tokens.by_ref().take_while(|t| *t != Token::Mark('}')).collect();
        let slot = |k: usize| Box::new(Expr::Slot(k));
        let times =
            |a: f64, k: usize| Box::new(Expr::Binary(BinaryOp::Mul, slot(k), Box::new(Expr::Const(a))));
        let expr = if body.len() == 4 {
            Expr::Binary(BinaryOp::Mul, slot(0), slot(1))
        } else {
            let xy = Expr::Binary(BinaryOp::Add, times(0.4, 0), times(0.1, 1));
            Expr::Binary(BinaryOp::Sub, Box::new(xy), times(0.3, 2))
        };
        PatternKind::Function(Arc::new(Function::new(3, expr)))
    }

    /// `{bozo color_map{[0 rgb <1,0,0>] ...}}`
    fn pigment_pattern(&mut self) -> PatternKind {
        self.skip('{');
        let pattern = Arc::new(bare(PatternKind::Bozo));
        assert_eq!((self.word(), self.word()), ("bozo".into(), "color_map".into()));
        self.skip('{');
        let mut map = Vec::new();
        while self.skip('[') {
            let at = self.number() as f32;
            assert_eq!(self.word(), "rgb");
            let c = self.vector();
            map.push((at, Color::opaque(c.x as f32, c.y as f32, c.z as f32)));
            self.skip(']');
        }
        self.skip('}');
        self.skip('}');
        let kind = PigmentKind::ColorMap { pattern, map: Arc::new(map) };
        PatternKind::Pigment(Arc::new(Pigment { kind, quick_color: None }))
    }

    /// `{sphere{0,2}}`
    fn object(&mut self) -> PatternKind {
        self.skip('{');
        assert_eq!(self.word(), "sphere");
        self.skip('{');
        let sphere = Shape::Sphere { center: self.vector(), radius: self.number() };
        self.skip('}');
        self.skip('}');
        PatternKind::Object(Arc::new(Object::new(ObjectKind::Shape(Arc::new(sphere)))))
    }

    /// `{png "name" options}`
    fn image(&mut self) -> PatternKind {
        self.skip('{');
        assert_eq!(self.word(), "png");
        let mut map: ImageMap = pictures::image_map(&self.text());
        while !self.skip('}') {
            match self.word().as_str() {
                "once" => map.once = true,
                "use_index" => map.use_index = true,
                "use_alpha" => map.use_alpha = true,
                "map_type" => {
                    map.map_type = match self.number() as u8 {
                        0 => MapType::Planar,
                        1 => MapType::Spherical,
                        2 => MapType::Cylindrical,
                        _ => MapType::Torus,
                    }
                }
                "interpolate" => {
                    map.interpolation = match self.number() as u8 {
                        2 => Interpolation::Bilinear,
                        3 => Interpolation::Bicubic,
                        _ => Interpolation::NormalizedDistance,
                    }
                }
                "repeat" => map.repeat = self.vector().truncate(),
                "offset" => map.offset = self.vector().truncate(),
                other => panic!("no image option {other}"),
            }
        }
        PatternKind::Image(Arc::new(map))
    }

    fn modifier(&mut self, word: &str, pattern: &mut Pattern) {
        match word {
            "translate" => transformed(pattern, transform::translate(self.vector())),
            "rotate" => transformed(pattern, transform::rotate(self.vector())),
            "scale" => transformed(pattern, transform::scale(self.vector())),
            "warp" => {
                let warp = self.warp();
                pattern.warps.insert(0, warp);
            }
            "turbulence" => classic(pattern).amount = self.vector(),
            "octaves" => classic(pattern).octaves = self.number() as u32,
            "omega" => classic(pattern).omega = self.number() as f32,
            "lambda" => classic(pattern).lambda = self.number() as f32,
            "noise_generator" => pattern.noise_generator = self.number() as u8,
            "frequency" => pattern.frequency = self.number() as f32,
            "phase" => pattern.phase = self.number() as f32,
            "ramp_wave" => pattern.wave = Wave::Ramp,
            "triangle_wave" => pattern.wave = Wave::Triangle,
            "sine_wave" => pattern.wave = Wave::Sine,
            "scallop_wave" => pattern.wave = Wave::Scallop,
            "cubic_wave" => pattern.wave = Wave::Cubic,
            "poly_wave" => pattern.wave = Wave::Poly(self.number() as f32),
            _ => self.setting(word, &mut pattern.kind),
        }
    }

    fn setting(&mut self, word: &str, kind: &mut PatternKind) {
        match (word, kind) {
            ("agate_turb", PatternKind::Agate { turbulence }) => *turbulence = self.number() as f32,
            ("brick_size", PatternKind::Brick { size, .. }) => *size = self.vector(),
            ("mortar", PatternKind::Brick { mortar, .. }) => *mortar = self.number() as f32,
            ("form", PatternKind::Crackle(c)) => c.form = self.vector(),
            ("metric", PatternKind::Crackle(c)) => c.metric = self.number(),
            ("offset", PatternKind::Crackle(c)) => c.offset = self.number(),
            ("solid", PatternKind::Crackle(c)) => c.solid = true,
            ("control0", PatternKind::Quilted { control0, .. }) => *control0 = self.number() as f32,
            ("control1", PatternKind::Quilted { control1, .. }) => *control1 = self.number() as f32,
            ("number_of_sides", PatternKind::Pavement { sides, .. }) => *sides = self.number() as u8,
            ("number_of_tiles", PatternKind::Pavement { tiles, .. }) => *tiles = self.number() as u8,
            ("pattern", PatternKind::Pavement { pattern, .. }) => *pattern = self.number() as u8,
            ("exterior", PatternKind::Pavement { exterior, .. }) => *exterior = self.number() as u8,
            ("interior", PatternKind::Pavement { interior, .. }) => *interior = self.number() as u8,
            ("form", PatternKind::Pavement { form, .. }) => *form = self.number() as u8,
            ("exponent", PatternKind::Fractal(f)) => f.kind = FractalKind::Power(self.number() as u8),
            ("exterior", PatternKind::Fractal(f)) => {
                (f.exterior_type, f.exterior_factor) = (self.number() as u8, self.number());
            }
            ("interior", PatternKind::Fractal(f)) => {
                (f.interior_type, f.interior_factor) = (self.number() as u8, self.number());
            }
            ("interpolate", PatternKind::DensityFile(file)) => {
                Arc::make_mut(file).interpolation = self.number() as u8;
            }
            (word, kind) => panic!("{word} in {kind:?}"),
        }
    }

    fn warp(&mut self) -> Warp {
        self.skip('{');
        let mut warp = match self.word().as_str() {
            "repeat" => {
                let by = self.vector();
                let axis = by.to_array().iter().position(|c| *c != 0.0).expect("a width");
                Warp::Repeat {
                    axis: axis as u8,
                    width: by[axis] as f32,
                    flip: Vec3::ZERO,
                    offset: Vec3::ZERO,
                }
            }
            "black_hole" => Warp::BlackHole {
                center: self.vector(),
                radius: self.number(),
                strength: 1.0,
                falloff: 2.0,
                inverse: false,
                repeat: None,
                turbulence: None,
            },
            "turbulence" => Warp::Turbulence(Turbulence { amount: self.vector(), ..Turbulence::default() }),
            "cylindrical" => Warp::Cylindrical { orientation: Vec3::Z, dist_exp: 0.0 },
            "spherical" => Warp::Spherical { orientation: Vec3::Z, dist_exp: 0.0 },
            "toroidal" => Warp::Toroidal { orientation: Vec3::Z, dist_exp: 0.0, major_radius: 1.0 },
            "planar" => Warp::Planar { orientation: self.vector(), distance: self.number() },
            "cubic" => Warp::Cubic,
            other => panic!("no warp {other}"),
        };
        while !self.skip('}') {
            let word = self.word();
            self.warp_setting(&word, &mut warp);
        }
        warp
    }

    fn warp_setting(&mut self, word: &str, warp: &mut Warp) {
        match (word, warp) {
            ("octaves", Warp::Turbulence(t)) => t.octaves = self.number() as u32,
            ("omega", Warp::Turbulence(t)) => t.omega = self.number() as f32,
            ("lambda", Warp::Turbulence(t)) => t.lambda = self.number() as f32,
            ("flip", Warp::Repeat { flip, .. }) => *flip = self.vector(),
            ("offset", Warp::Repeat { offset, .. }) => *offset = self.vector(),
            ("strength", Warp::BlackHole { strength, .. }) => *strength = self.number(),
            ("falloff", Warp::BlackHole { falloff, .. }) => *falloff = self.number(),
            ("inverse", Warp::BlackHole { inverse, .. }) => *inverse = true,
            ("repeat", Warp::BlackHole { repeat, .. }) => *repeat = Some(self.vector()),
            ("turbulence", Warp::BlackHole { turbulence, .. }) => *turbulence = Some(self.vector()),
            ("major_radius", Warp::Toroidal { major_radius, .. }) => *major_radius = self.number(),
            (
                word,
                Warp::Cylindrical { orientation, dist_exp }
                | Warp::Spherical { orientation, dist_exp }
                | Warp::Toroidal { orientation, dist_exp, .. },
            ) => match word {
                "orientation" => *orientation = self.vector(),
                "dist_exp" => *dist_exp = self.number(),
                other => panic!("no warp option {other}"),
            },
            (word, warp) => panic!("{word} in {warp:?}"),
        }
    }
}

/// A pattern without anything around it.
pub fn bare(kind: PatternKind) -> Pattern {
    Pattern { kind, warps: Vec::new(), wave: Wave::Ramp, frequency: 1.0, phase: 0.0, noise_generator: 0 }
}

/// Puts a transform at the head of the list, or into the one that stands there.
pub fn transformed(pattern: &mut Pattern, t: Affine) {
    if let Some(Warp::Transform { forward, inverse }) = pattern.warps.first_mut() {
        *forward = t * *forward;
        *inverse = forward.inverse();
    } else {
        pattern.warps.insert(0, Warp::Transform { forward: t, inverse: t.inverse() });
    }
}

/// The classic turbulence at the list's tail.
fn classic(pattern: &mut Pattern) -> &mut Turbulence {
    if !matches!(pattern.warps.last(), Some(Warp::ClassicTurbulence(_))) {
        pattern.warps.push(Warp::ClassicTurbulence(Turbulence::default()));
    }
    match pattern.warps.last_mut() {
        Some(Warp::ClassicTurbulence(turbulence)) => turbulence,
        _ => unreachable!("it was just put there"),
    }
}
