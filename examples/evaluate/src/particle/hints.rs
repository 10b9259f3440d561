//! What a person says of each photograph: which tree it is, and where strokes are needed, those.

use super::scribbles::{
    ASH, BEECH, BIGLEAF, BOXELDER, BUR_OAK, CHERRY, CYPRESS, LOCUST, OSAGE_ORANGE, PONDEROSA,
    RED_MAPLE, REDBUD, REDCEDAR, REDWOOD, SAPLING, WESTERN_REDCEDAR,
};
use std::error::Error;
use tree_model::glam::Vec2;
use tree_model::particle::matting::Stroke;

/// How the tree is separated from what is behind it.
#[derive(Clone, Copy, Debug)]
pub(crate) enum How {
    /// By the picture's own alpha.
    Alpha,
    /// As a tree against the sky.
    Auto,
    /// By strokes of a person.
    Scribbles(&'static [Scribble]),
}

impl How {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Alpha => "alpha",
            Self::Auto => "auto",
            Self::Scribbles(_) => "scribbles",
        }
    }
}

/// A photograph of the shared data.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hint {
    pub(crate) file: &'static str,
    pub(crate) species: &'static str,
    /// Whether it stands without leaves.
    pub(crate) bare: bool,
    pub(crate) how: How,
}

/// A stroke of a brush over a photograph.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scribble {
    tree: bool,
    width: f32,
    /// "x,y x,y ..." in pixels, as in SVG.
    points: &'static str,
}

impl Scribble {
    /// # Errors
    /// Points that are not numbers.
    pub(crate) fn stroke(&self) -> Result<Stroke, Box<dyn Error>> {
        let point = |text: &str| -> Result<Vec2, Box<dyn Error>> {
            let (x, y) = text.split_once(',').ok_or("a point without a comma")?;
            Ok(Vec2::new(x.parse()?, y.parse()?))
        };
        let points = self.points.split_whitespace().map(point).collect::<Result<_, _>>()?;
        Ok(Stroke { points, width: self.width, foreground: self.tree })
    }
}

/// On the tree.
pub(super) const fn on(width: f32, points: &'static str) -> Scribble {
    Scribble { tree: true, width, points }
}

/// Off the tree.
pub(super) const fn off(width: f32, points: &'static str) -> Scribble {
    Scribble { tree: false, width, points }
}

const fn leafy(file: &'static str, species: &'static str, how: How) -> Hint {
    Hint { file, species, bare: false, how }
}

const fn bare(file: &'static str, species: &'static str, how: How) -> Hint {
    Hint { file, species, bare: true, how }
}

pub(crate) const HINTS: [Hint; 21] = [
    leafy("cutout_holm_oak.png", "oak", How::Alpha),
    bare("cutout_birch_winter.png", "birch", How::Alpha),
    leafy("cutout_pinnate_tree.png", "walnut", How::Alpha),
    leafy("american_beech_young.jpg", "beech", How::Scribbles(BEECH)),
    leafy("bald_cypress_pond.jpg", "larch", How::Scribbles(CYPRESS)),
    leafy("boxelder_lawn.jpg", "maple", How::Scribbles(BOXELDER)),
    leafy("bur_oak_sunset.jpg", "oak", How::Scribbles(BUR_OAK)),
    leafy("catalpa_park.jpg", "linden", How::Auto),
    leafy("cherry_in_flower.jpg", "birch", How::Scribbles(CHERRY)),
    leafy("coast_redwood_conifer.jpg", "spruce", How::Scribbles(REDWOOD)),
    leafy("eastern_redcedar_golf.jpg", "spruce", How::Scribbles(REDCEDAR)),
    leafy("osage_orange_autumn.jpg", "linden", How::Scribbles(OSAGE_ORANGE)),
    leafy("ponderosa_pine_slope.jpg", "pine", How::Scribbles(PONDEROSA)),
    leafy("sugar_maple_autumn.jpg", "maple", How::Auto),
    leafy("western_redcedar_crown.jpg", "spruce", How::Scribbles(WESTERN_REDCEDAR)),
    leafy("white_ash_sapling.jpg", "ash", How::Scribbles(ASH)),
    bare("hard_bigleaf_maple_sparse.jpg", "maple", How::Scribbles(BIGLEAF)),
    bare("hard_flowering_sapling_campus.jpg", "birch", How::Scribbles(SAPLING)),
    leafy("hard_honey_locust_hedge.jpg", "mimosa", How::Scribbles(LOCUST)),
    leafy("hard_red_maple_house.jpg", "maple", How::Scribbles(RED_MAPLE)),
    leafy("hard_redbud_garden.jpg", "linden", How::Scribbles(REDBUD)),
];
