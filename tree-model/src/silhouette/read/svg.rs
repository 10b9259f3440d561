//! Outlines from SVG drawings: in layers, or whole silhouettes.

use super::cells::Grid;
use super::raster;
use super::whole::Silhouette;
use super::{Kind, Level, LevelStroke, OutlineDrawing, ReadRepair, TreeStrokes};
use crate::error::{ModelError, Result};
use crate::sketch::Role;
use crate::svg::{self, Contour, Ink, Shape};
use glam::Vec2;

/// Green, or brown: one channel outweighs the others by at least this many of 255.
const HUE: u8 = 12;

/// Ink so light in every channel is the paper's: it erases.
const WHITE: u8 = 236;

/// Open ends farther apart than this share of a line's length make it a line, not an outline.
const OPEN: f32 = 0.3;

/// Reads outlines from an SVG drawing; coordinates in its units, y down. What is not seen is left out.
///
/// **Layers** are groups, or single shapes, by id, class, layer label or name, in any case: `L0`, `L1`, `L2`, … and `leaf`
/// or `leaves`. The innermost number counts; `L0@90` is drawn in a plane turned about the trunk by so many degrees. In
/// `L0`, what has the word *trunk* or *stem* in a name, and an open line, is the trunk; what is closed or filled, or has the
/// word *crown*, *outline*, *foliage*, *canopy* or *silhouette*, is the crown. In other layers, what is closed or filled is
/// the outline of a branch, an open line is a branch redrawn. In `leaf`, all are outlines. A trunk drawn as an area
/// becomes its middle line.
///
/// **Trees**: groups named `tree`, `tree1`, `tree-oak` hold one tree each. Without them there is one tree.
///
/// **Without layers** what is filled is one silhouette for each tree. Its trunk is what is named so; or what is brown where
/// something else is green; or the narrow part above the foot. The rest is its crown. White ink erases. Open lines
/// are the trunk where there is no other; closed lines count as filled.
///
/// # Errors
/// [`ModelError::Svg`] when the text is no SVG or draws nothing; [`ModelError::Silhouette`] where
/// nothing of it is a tree.
///
/// # Complexity
/// O(bytes + points), and some tens of milliseconds for each whole silhouette.
pub fn from_svg(text: &str) -> Result<OutlineDrawing> {
    let drawing = svg::read(text)?;
    let seen: Vec<Named<'_>> = drawing
        .shapes
        .iter()
        .filter(|s| s.paint.is_seen())
        .map(|s| Named::of(s, &drawing))
        .collect();
    if seen.is_empty() {
        return Err(ModelError::Svg("no line or shape that is seen was found".into()));
    }
    let layered = seen.iter().any(|shape| matches!(shape.layer, Some((Level::Number(_), _))));
    let mut out = OutlineDrawing::default();
    for (name, shapes) in trees(seen, layered, &mut out.repairs) {
        let tree = if layered {
            Ok(layers(name, &shapes, &mut out.repairs))
        } else {
            whole(&name, &shapes, drawing.view, &mut out.repairs)
        };
        match tree {
            Ok(tree) if !tree.strokes.is_empty() => out.trees.push(tree),
            Ok(tree) => out.repairs.push(ReadRepair::TreeDropped { tree: tree.name }),
            Err(ModelError::Silhouette { what, .. }) => {
                out.repairs.push(ReadRepair::TreeDropped { tree: what });
            }
            Err(other) => return Err(other),
        }
    }
    if out.trees.is_empty() {
        let problem = "nothing in it is a tree: fill its shape, or draw it in layers L0, L1, …";
        return Err(ModelError::Silhouette { what: "drawing".into(), problem: problem.into() });
    }
    Ok(out)
}

/// A shape and what the names about it say.
struct Named<'a> {
    shape: &'a Shape,
    /// Level and azimuth in radians.
    layer: Option<(Level, f32)>,
    /// The element that is its tree, and its name.
    tree: Option<(usize, &'a str)>,
    name: &'a str,
    silhouette: bool,
}

impl<'a> Named<'a> {
    fn of(shape: &'a Shape, drawing: &'a svg::Drawing) -> Self {
        let mut named = Self {
            shape,
            layer: None,
            tree: None,
            name: shape.id.as_deref().unwrap_or(""),
            silhouette: false,
        };
        let mut leaf = None;
        let mut at = shape.element;
        while let Some(element) = at.and_then(|at| drawing.elements.get(at)) {
            for name in &element.names {
                named.layer = named.layer.or_else(|| layer_named(name));
                let azimuth = azimuth_after(name, 0);
                let has = |known: &[&str]| {
                    words(name)
                        .any(|word| known.iter().any(|known| known.eq_ignore_ascii_case(word)))
                };
                if leaf.is_none() && has(&["leaf", "leaves"]) {
                    leaf = Some((Level::Leaf, azimuth));
                }
                named.silhouette |= has(&["silhouette", "silhouettes"]);
                if element.is_group
                    && let Some(at) = at
                    && is_tree(name)
                {
                    named.tree = Some((at, name));
                }
            }
            at = element.outer;
        }
        named.layer = named.layer.or(leaf);
        named
    }

    /// Whether it is filled; an open line with a stroke is not.
    fn is_filled(&self, contour: &Contour) -> bool {
        let paint = self.shape.paint;
        let area = contour.points.len() > 2;
        area && paint.fill.is_some() && (paint.stroke.is_none() || contour.closed)
    }
}

/// The words of a name, of letters only.
fn words(name: &str) -> impl Iterator<Item = &str> {
    name.split(|c: char| !c.is_alphabetic())
}

/// Whether a name is that of a tree: `tree`, `tree1`, `tree-oak`.
fn is_tree(name: &str) -> bool {
    words(name).any(|word| word.eq_ignore_ascii_case("tree"))
}

/// The layer that a name speaks of: `L1`, `my L0@90`, `L2-left`.
fn layer_named(name: &str) -> Option<(Level, f32)> {
    let mut before = ' ';
    for (at, c) in name.char_indices() {
        let begins = matches!(c, 'L' | 'l') && !before.is_alphanumeric();
        before = c;
        if !begins {
            continue;
        }
        let rest = &name[at + 1..];
        let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let ends = rest[digits..].chars().next().is_none_or(|c| !c.is_alphanumeric());
        if let Ok(level) = rest[..digits].parse::<u32>()
            && ends
        {
            return Some((Level::Number(level), azimuth_after(name, at)));
        }
    }
    None
}

/// The azimuth in radians after an `@`, which some programs write `_x40_` in ids; 0 where there is none.
fn azimuth_after(name: &str, from: usize) -> f32 {
    let rest = name.get(from..).unwrap_or("");
    let at = |mark: &str| rest.find(mark).map(|at| &rest[at + mark.len()..]);
    let Some(number) = at("@").or_else(|| at("_x40_")) else { return 0.0 };
    let ends = |c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+'));
    let degrees: f32 = number.split(ends).next().and_then(|n| n.parse().ok()).unwrap_or(0.0);
    if degrees.is_finite() { (degrees % 360.0).to_radians() } else { 0.0 }
}

/// The shapes of each tree, in order. What belongs to none is left out where whole silhouettes have groups, and a
/// tree of its own where there are layers.
fn trees<'a>(
    shapes: Vec<Named<'a>>,
    layered: bool,
    repairs: &mut Vec<ReadRepair>,
) -> Vec<(String, Vec<Named<'a>>)> {
    let grouped = shapes.iter().any(|shape| shape.tree.is_some());
    let mut trees: Vec<(Option<usize>, String, Vec<Named<'a>>)> = Vec::new();
    let mut stray = 0;
    for shape in shapes {
        if (layered && shape.layer.is_none()) || (!layered && grouped && shape.tree.is_none()) {
            stray += 1;
            continue;
        }
        let (key, name) = shape.tree.map_or((None, ""), |(at, name)| (Some(at), name));
        // Groups follow one another: the last is likeliest.
        match trees.iter_mut().rev().find(|tree| tree.0 == key) {
            Some(tree) => tree.2.push(shape),
            None => trees.push((key, name.into(), vec![shape])),
        }
    }
    if stray > 0 {
        repairs.push(ReadRepair::StrayShapes { count: stray });
    }
    trees.into_iter().map(|(_, name, shapes)| (name, shapes)).collect()
}

/// The points of a contour, finite, none repeated at once, and the first not at the end of a closed one.
fn points(contour: &Contour) -> Vec<Vec2> {
    let all = contour.points.iter().map(|p| Vec2::new(p.x as f32, p.y as f32));
    let mut points: Vec<Vec2> = all.filter(|p| p.is_finite()).collect();
    points.dedup();
    while contour.closed && points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    points
}

/// A tree drawn in layers.
fn layers(name: String, shapes: &[Named<'_>], repairs: &mut Vec<ReadRepair>) -> TreeStrokes {
    let mut tree = TreeStrokes { name, ..TreeStrokes::default() };
    for shape in shapes {
        let Some((level, azimuth)) = shape.layer else { continue };
        for contour in &shape.shape.contours {
            let points = points(contour);
            let area = contour.closed || shape.is_filled(contour);
            let named_outline = shape.shape.role == Some(Role::Crown) || shape.silhouette;
            let kind = match level {
                Level::Leaf => Kind::Outline,
                Level::Number(0) if shape.shape.role == Some(Role::Trunk) => Kind::Axis,
                Level::Number(0) if named_outline => Kind::Outline,
                Level::Number(_) if area => Kind::Outline,
                Level::Number(_) => Kind::Axis,
            };
            let points = if kind == Kind::Axis && area {
                let Some((line, width)) = middle_line(&points) else { continue };
                repairs.push(ReadRepair::TrunkThinned { tree: tree.name.clone() });
                tree.trunk_width = tree.trunk_width.or(Some(width));
                line
            } else {
                points
            };
            if points.len() > 1 {
                let name = shape.name.into();
                tree.strokes.push(LevelStroke { level, kind, azimuth, points, name });
            }
        }
    }
    tree
}

/// The middle line and the width of a trunk drawn as an area.
fn middle_line(contour: &[Vec2]) -> Option<(Vec<Vec2>, f32)> {
    let grid = grid_over(&[contour.to_vec()])?;
    let mask = raster::mask(&grid, &[contour.to_vec()]);
    let (mask, _) = grid.bridge(&mask, 1, 1);
    let trunk = super::trunk::Trunk::given(&grid, &mask, f32::INFINITY)?;
    Some((trunk.line(&grid), trunk.width(&grid)))
}

fn grid_over(contours: &[Vec<Vec2>]) -> Option<Grid> {
    let all = || contours.iter().flatten().copied();
    let (low, high) =
        (all().fold(Vec2::INFINITY, Vec2::min), all().fold(Vec2::NEG_INFINITY, Vec2::max));
    Grid::over(low, high, 0.0)
}

/// The areas of one shape of a whole silhouette.
struct Area {
    contours: Vec<Vec<Vec2>>,
    even_odd: bool,
    erases: bool,
    role: Option<Role>,
}

/// A tree drawn as one silhouette, of several shapes perhaps.
fn whole(
    name: &str,
    shapes: &[Named<'_>],
    view: Option<kurbo::Rect>,
    repairs: &mut Vec<ReadRepair>,
) -> Result<TreeStrokes> {
    let mut areas = Vec::new();
    let mut lines: Vec<(&Named<'_>, Vec<Vec2>)> = Vec::new();
    for (i, named) in shapes.iter().enumerate() {
        let shape = named.shape;
        if i == 0 && shapes.len() > 1 && view.is_some_and(|view| is_background(shape, view)) {
            repairs.push(ReadRepair::BackgroundDropped);
            continue;
        }
        let mut contours = Vec::new();
        for contour in &shape.contours {
            let points = points(contour);
            if named.is_filled(contour) || contour.closed || !is_open(&points) {
                contours.push(points);
            } else {
                lines.push((named, points));
            }
        }
        contours.retain(|contour| contour.len() > 2);
        let ink = shape.paint.fill.or(shape.paint.stroke);
        let erases = matches!(ink, Some(Ink::Plain(c)) if c.iter().all(|&c| c >= WHITE));
        let role = shape.role.or_else(|| ink.and_then(role_of));
        areas.push(Area { contours, even_odd: shape.even_odd, erases, role });
    }
    areas.retain(|area| !area.contours.is_empty());
    let mut tree = silhouette(name, &areas, repairs)?;
    drawn_trunk(&mut tree, &lines, repairs);
    Ok(tree)
}

/// An open line for a trunk where the silhouette shows none.
fn drawn_trunk(
    tree: &mut TreeStrokes,
    lines: &[(&Named<'_>, Vec<Vec2>)],
    repairs: &mut Vec<ReadRepair>,
) {
    let has_trunk = tree.strokes.iter().any(|stroke| stroke.kind == Kind::Axis);
    let upright = |points: &[Vec2]| match (points.first(), points.last()) {
        (Some(a), Some(b)) => (b.y - a.y).abs(),
        _ => 0.0,
    };
    let named = |line: &&(&Named<'_>, Vec<Vec2>)| line.0.shape.role == Some(Role::Trunk);
    let tallest = lines.iter().max_by(|a, b| upright(&a.1).total_cmp(&upright(&b.1)));
    let trunk = lines.iter().find(named).or(tallest).filter(|_| !has_trunk);
    if let Some((named, points)) = trunk {
        repairs.retain(|repair| *repair != ReadRepair::NoTrunk);
        let (level, kind, azimuth) = (Level::Number(0), Kind::Axis, 0.0);
        let stroke =
            LevelStroke { level, kind, azimuth, points: points.clone(), name: named.name.into() };
        tree.strokes.insert(0, stroke);
    }
    let count = lines.len() - usize::from(trunk.is_some());
    if count > 0 {
        repairs.push(ReadRepair::LinesDropped { count });
    }
}

/// Whether a line's ends are far apart.
fn is_open(points: &[Vec2]) -> bool {
    let length: f32 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    match (points.first(), points.last()) {
        (Some(a), Some(b)) => a.distance(*b) > OPEN * length,
        _ => true,
    }
}

/// Whether a shape is a rectangle as large as the drawing.
fn is_background(shape: &Shape, view: kurbo::Rect) -> bool {
    let few = shape.contours.len() == 1 && shape.contours.iter().all(|c| c.points.len() <= 5);
    let (low, high) = (shape.bounds.intersect(view), 0.98);
    few && low.width() >= high * view.width() && low.height() >= high * view.height()
}

/// Green is the crown; brown is the trunk.
fn role_of(ink: Ink) -> Option<Role> {
    let Ink::Plain([red, green, blue]) = ink else { return None };
    if green >= red.max(blue).saturating_add(HUE) {
        Some(Role::Crown)
    } else if red >= green.saturating_add(HUE) && green >= blue {
        Some(Role::Trunk)
    } else {
        None
    }
}

/// Trunk and crown of areas painted one over the other.
fn silhouette(name: &str, areas: &[Area], repairs: &mut Vec<ReadRepair>) -> Result<TreeStrokes> {
    let contours: Vec<Vec<Vec2>> =
        areas.iter().filter(|area| !area.erases).flat_map(|area| area.contours.clone()).collect();
    let Some(grid) = grid_over(&contours) else {
        let what = if name.is_empty() { "silhouette" } else { name }.into();
        return Err(ModelError::Silhouette { what, problem: "nothing in it is filled".into() });
    };
    let has = |role| areas.iter().any(|area| area.role == Some(role));
    // Where only crowns are told, the rest is the trunk.
    let rest = has(Role::Crown) && !has(Role::Trunk);
    let tells = has(Role::Trunk) || rest;
    let mut cover = vec![0.0_f32; grid.nx * grid.ny];
    let mut wood = if tells { cover.clone() } else { Vec::new() };
    for area in areas {
        let is_wood = area.role == Some(Role::Trunk) || (rest && area.role != Some(Role::Crown));
        let solid = f32::from(u8::from(!area.erases));
        let woody = f32::from(u8::from(is_wood && !area.erases));
        raster::paint(&grid, &area.contours, area.even_odd, |at, part| {
            cover[at] += part * (solid - cover[at]);
            if let Some(wood) = wood.get_mut(at) {
                *wood += part * (woody - *wood);
            }
        });
    }
    Silhouette { grid, cover, wood, frayed: false }.strokes(name, 0.0, repairs)
}
