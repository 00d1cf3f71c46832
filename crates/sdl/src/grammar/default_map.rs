//! The colours that a pattern shows when the scene gives it no map (textures spec, section 9.1).
use raggio_scene::{Color, ColorMap, FractalKind, FractalSettings, PatternKind};

const BLACK: Color = Color::BLACK;
const WHITE: Color = Color::WHITE;
const RED: Color = Color::opaque(1.0, 0.0, 0.0);
const GREEN: Color = Color::opaque(0.0, 1.0, 0.0);
const BLUE: Color = Color::opaque(0.0, 0.0, 1.0);
const YELLOW: Color = Color::opaque(1.0, 1.0, 0.0);
const CYAN: Color = Color::opaque(0.0, 1.0, 1.0);
const MAGENTA: Color = Color::opaque(1.0, 0.0, 1.0);

/// The map of a pattern that has been given none.
pub fn colors(kind: &PatternKind) -> ColorMap {
    let list = |colors: &[Color]| colors.iter().enumerate().map(|(i, &c)| (i as f32, c)).collect();
    match kind {
        PatternKind::Checker | PatternKind::Object(_) => list(&[BLUE, GREEN]),
        PatternKind::Brick { .. } => list(&[Color::opaque(0.5, 0.5, 0.5), Color::opaque(0.6, 0.15, 0.15)]),
        PatternKind::Hexagon => list(&[BLUE, GREEN, RED]),
        PatternKind::Square => list(&[RED, GREEN, BLUE, YELLOW]),
        PatternKind::Triangular | PatternKind::Cubic => list(&[RED, GREEN, BLUE, YELLOW, CYAN, MAGENTA]),
        _ => continuous(kind),
    }
}

/// Black to white, which `spotted` and `bumps` have although `bozo`, the same formula, has colours.
pub fn grey() -> ColorMap {
    vec![(0.0, BLACK), (1.0, WHITE)]
}

fn continuous(kind: &PatternKind) -> ColorMap {
    match kind {
        PatternKind::Bozo => {
            vec![(0.4, WHITE), (0.4, GREEN), (0.6, GREEN), (0.6, BLUE), (0.8, BLUE), (0.8, RED)]
        }
        PatternKind::Wood => {
            vec![(0.6, Color::opaque(0.666, 0.312, 0.2)), (0.6, Color::opaque(0.4, 0.1333, 0.066))]
        }
        PatternKind::Fractal(FractalSettings { kind: FractalKind::Power(2), julia: None, .. }) => {
            vec![(0.001, BLACK), (0.001, CYAN), (0.012, YELLOW), (0.015, MAGENTA), (0.1, CYAN)]
        }
        PatternKind::Agate { .. } => vec![
            (0.0, WHITE),
            (0.5, Color::opaque(0.95, 0.75, 0.5)),
            (0.5, Color::opaque(0.9, 0.7, 0.5)),
            (0.6, Color::opaque(0.9, 0.7, 0.4)),
            (0.6, Color::opaque(1.0, 0.7, 0.4)),
            (1.0, Color::opaque(0.6, 0.3, 0.0)),
        ],
        PatternKind::Radial => vec![(0.0, CYAN), (0.333, YELLOW), (0.666, MAGENTA), (1.0, CYAN)],
        PatternKind::Marble => {
            vec![(0.0, Color::opaque(0.9, 0.8, 0.8)), (0.9, Color::opaque(0.9, 0.08, 0.08)), (0.9, BLACK)]
        }
        _ => grey(),
    }
}
