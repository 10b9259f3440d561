//! Grammars, drawings and mattes by chance.

use super::dice::Dice;
use tree_core::glam::Vec2;
use tree_model::ModelError;
use tree_model::particle::Matte;
use tree_model::silhouette::read::{Kind, Level, LevelStroke, TreeStrokes};
use tree_model::sketch::{Drawing, Role, Stroke};

/// What productions are made of.
const MODULES: [&str; 26] = [
    "F(l)",
    "F",
    "[+A(l*K)]",
    "[-A(l*K)]",
    "[&(N)B(l)]",
    "/(137.5)",
    "+(N)",
    "!(l*K)",
    "A(l*K)",
    "B(l+K)",
    "[^F(l)L]",
    "~(l)",
    "$",
    "G(l)",
    "f",
    "[+(N)F(l)L]",
    "[F]",
    "%",
    "\\(N)",
    "|",
    "{.F.F.}",
    "@O(l)",
    "C",
    "F(l/K)",
    "F(ran(N))",
    "A(l^K)",
];
/// Pieces that are nearly right.
const PIECES: [&str; 16] = [
    "->",
    ":",
    "<",
    ">",
    "(",
    ")",
    ",",
    "#ignore +-\n",
    "decomposition\n",
    "1/0",
    "ε",
    "/*",
    "=",
    "if(l,1,2)",
    "-",
    "sin(l)",
];
/// Points of a stroke.
const POINTS: usize = 24;
/// Side of a matte in pixels.
const SIDE: [u32; 2] = [20, 28];

/// The text of a grammar: mostly one that grows, now and then spoilt.
pub(super) fn grammar(dice: &mut Dice) -> String {
    let mut text = format!("angle: {}\naxiom: A({})\n", number(dice), number(dice));
    for left in
        ["A(l)", "A(l) : l > 0.1", "B(l)", "F(l) : l < 1", "C"].iter().take(1 + dice.below(5))
    {
        text += &format!("{left} -> {}\n", successor(dice));
        if dice.chance(0.2) && !left.contains(':') {
            text.pop();
            text += &format!(" : {}\n{left} -> {} : 1\n", number(dice), successor(dice));
        }
    }
    if dice.chance(0.2) {
        let mut at = dice.below(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        text.insert_str(at, dice.pick(&PIECES).unwrap_or(""));
    }
    text
}

fn successor(dice: &mut Dice) -> String {
    let mut right = String::new();
    for _ in 0..1 + dice.below(8) {
        let piece = dice.pick(&MODULES).unwrap_or("F");
        right += &piece.replace('K', &number(dice)).replace('N', &number(dice));
    }
    right
}

fn number(dice: &mut Dice) -> String {
    match dice.below(12) {
        0 => "0".into(),
        1 => "-1".into(),
        2 => "1e30".into(),
        3 => "1e308".into(),
        4 => "1e-30".into(),
        5 if dice.chance(0.1) => "1e999".into(),
        5 => "7".into(),
        6 => "90".into(),
        _ => format!("{:.3}", dice.between(0.3, 1.5)),
    }
}

/// A line that wanders, with a broken point now and then.
fn line(dice: &mut Dice, from: Vec2, way: Vec2) -> Vec<Vec2> {
    let nasty = if dice.chance(0.08) { 0.1 } else { 0.0 };
    let mut at = from;
    let mut points = Vec::new();
    for _ in 0..1 + dice.below(POINTS) {
        points.push(at);
        if !dice.chance(0.05) {
            at += way * dice.between(0.2, 1.5) + dice.spot(0.4 * way.length(), nasty);
        }
    }
    points
}

/// A star round a centre, or a tangle.
fn outline(dice: &mut Dice, center: Vec2, reach: f32) -> Vec<Vec2> {
    let nasty = if dice.chance(0.05) { 0.05 } else { 0.0 };
    if dice.chance(0.15) {
        let n = dice.below(POINTS);
        return (0..n).map(|_| center + dice.spot(reach, nasty)).collect();
    }
    let (n, rough) = (3 + dice.below(40), dice.between(0.0, 0.6));
    let flat = dice.between(0.3, 1.5);
    (0..n)
        .map(|i| {
            let turn = i as f32 / n as f32 * std::f32::consts::TAU;
            let radius = reach * (1.0 - dice.between(0.0, rough));
            center
                + radius * Vec2::new(flat * libm::cosf(turn), libm::sinf(turn))
                + dice.spot(0.0, nasty)
        })
        .collect()
}

/// A crown, mostly on a trunk, with outlines of branches and of a leaf now and then.
pub(super) fn outlines(dice: &mut Dice) -> TreeStrokes {
    let mut strokes = Vec::new();
    let mut draw = |level, kind, azimuth, points| {
        strokes.push(LevelStroke { level, kind, azimuth, points, name: String::new() });
    };
    if dice.chance(0.8) {
        draw(
            Level::Number(0),
            Kind::Axis,
            0.0,
            line(dice, Vec2::new(0.0, 100.0), Vec2::new(0.0, -9.0)),
        );
    }
    if dice.chance(0.95) {
        draw(Level::Number(0), Kind::Outline, 0.0, outline(dice, Vec2::new(0.0, 40.0), 45.0));
    }
    for _ in 0..dice.below(4) {
        let (center, reach) = (dice.spot(40.0, 0.02), dice.between(5.0, 30.0));
        let level = Level::Number(1 + dice.below(2) as u32);
        let azimuth = dice.coordinate(0.5, 0.1);
        if dice.chance(0.5) {
            draw(level, Kind::Outline, azimuth, outline(dice, center, reach));
        } else {
            draw(level, Kind::Axis, azimuth, line(dice, Vec2::new(0.0, 50.0), 0.1 * center));
        }
    }
    if dice.chance(0.2) {
        draw(Level::Leaf, Kind::Outline, 0.0, outline(dice, Vec2::ZERO, 3.0));
    }
    let trunk_width = dice.chance(0.3).then(|| dice.coordinate(4.0, 0.2));
    TreeStrokes { name: String::new(), strokes, trunk_width }
}

/// A few strokes, from the trunk more often than not.
pub(super) fn sketch(dice: &mut Dice) -> Drawing {
    let mut strokes = Vec::new();
    if dice.chance(0.85) {
        let points = line(dice, Vec2::new(100.0, 300.0), Vec2::new(0.0, -18.0));
        strokes
            .push(Stroke { role: dice.chance(0.7).then_some(Role::Trunk), ..Stroke::new(points) });
    }
    for _ in 0..dice.below(7) {
        let from = strokes.first().and_then(|trunk| {
            let at = dice.below(trunk.points.len());
            trunk.points.get(at).copied()
        });
        let from = from.unwrap_or(Vec2::new(100.0, 150.0)) + dice.spot(3.0, 0.01);
        let way = Vec2::new(dice.between(-14.0, 14.0), dice.between(-14.0, 4.0));
        let role = [None, Some(Role::Branch), Some(Role::Branch), Some(Role::Crown)];
        strokes.push(Stroke {
            role: dice.pick(&role).flatten(),
            closed: dice.chance(0.1),
            filled: dice.chance(0.1),
            ..Stroke::new(line(dice, from, way))
        });
    }
    if dice.chance(0.3) {
        let points = outline(dice, Vec2::new(100.0, 120.0), 90.0);
        strokes.push(Stroke { closed: true, ..Stroke::of(Role::Crown, points) });
    }
    Drawing { strokes }
}

/// A crown on a trunk, noise, or nothing.
pub(super) fn matte(dice: &mut Dice) -> Result<Matte, ModelError> {
    let [width, height] = SIDE;
    let center = Vec2::new(dice.between(4.0, 16.0), dice.between(5.0, 14.0));
    let half = Vec2::new(dice.between(1.0, 9.0), dice.between(1.0, 9.0));
    let (noise, trunk) = (dice.between(0.0, 0.3), dice.between(0.0, 3.0));
    let level = if dice.chance(0.1) { dice.between(0.0, 1.0) } else { 1.0 };
    let alpha = (0..width * height).map(|i| {
        let at = Vec2::new((i % width) as f32, (i / width) as f32) + 0.5;
        let crown = ((at - center) / half).length_squared() < 1.0;
        let stem = (at.x - center.x).abs() < trunk && at.y > center.y && at.y < 26.0;
        if (crown || stem) != dice.chance(0.3 * noise) { level } else { 0.0 }
    });
    Matte::new(width, height, alpha.collect())
}
