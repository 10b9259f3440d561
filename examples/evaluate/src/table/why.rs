//! Why rows miss their aims, where that is known: what was found when the row's system was built, and written down with it.

/// System, part of the case, part of the figure's name, reason; the first that fits.
const REASONS: &[(&str, &str, &str, &str)] = &[
    ("path", "graphs of", "petgraph", TINY_GRAPHS),
    ("path", "", "time", CLOCK),
    ("particle", "stay apart", "simulation", CROWDED),
    ("particle", "matting, cutout_birch", "peer's", MARKED_TWIGS),
    ("particle", "synthetic", "F1", HOLLOW),
    ("particle", "cutout_birch", "F1", TWIGS),
    ("particle", "bigleaf_maple", "F1", TWIGS),
    ("particle", "flowering_sapling", "F1", TWIGS),
    ("sketch", "", "branches through others", TOUCHING),
    ("sketch", "", "leafy tree", CLOCK),
    ("silhouette", "slowest", "coverage", CLOCK),
    ("silhouette", "palm", "IoU", FRONDS),
    ("silhouette", "fern", "IoU", FRONDS),
    ("silhouette", "willow", "refused", NO_BRANCH),
    ("mesh", "bark of", "", CLOCK),
    ("mesh", "leaf cards", "time", CLOCK),
    ("mesh", "", "crossing pairs", SIDE_BY_SIDE),
    ("mesh", "", "self-intersecting", SIDE_BY_SIDE),
    ("prune", "Table 7.4", "saved", HEURISTICS),
    ("prune", "cards, all", "mean Q", CARDS),
    ("prune", "billboards", "", BILLBOARDS),
    ("prune", "eztree", "coverage", LARGE_TRIANGLES),
    ("prune", "eztree", "any view", LARGE_TRIANGLES),
    ("prune", "oak, cards, ours", "red", FEW_RED),
    ("prune", "half a million", "time", CLOCK),
    ("plastic", "Table 2: 10 years", "transformation", SEASONS),
    ("plastic", "crowns touch", "update", NEIGHBOURS),
    ("plastic", "puu1", "trunk", PUU1),
];

const CLOCK: &str = "a time: it held when this part was built, on the same kind of machine in a quieter hour, which was 1.3 to 1.7 times as fast";
const TINY_GRAPHS: &str = "mispredicted branches decide on graphs this small; the ratio swings from run to run, and the search is a tenth of a tree's time";
const CROWDED: &str =
    "particles kept apart crowd in the trunk, where a uniform grid finds neighbours slowly";
const MARKED_TWIGS: &str =
    "marking clear pixels as known hurts between leafless twigs; `mark_clear: false` helps there";
const HOLLOW: &str =
    "a sparse, wide crown: two silhouettes cannot say where between its limbs it is hollow";
const TWIGS: &str =
    "a bare or sparse tree: its fine twigs would have to follow those of the picture";
const TOUCHING: &str = "two pairs of branches in 20 dense drawings touch; whether there is an arrangement without is not known";
const FRONDS: &str = "fronds a sixtieth as wide as the tree: thick limbs cut their corners";
const NO_BRANCH: &str =
    "one small outline of the drawing matches no branch, and is refused as it should be";
const SIDE_BY_SIDE: &str = "branches that cross in space far from any fork: planned paths run side by side, and the mesher fuses what leaves a wall together";
const HEURISTICS: &str = "the paper's heuristics on other models (its own are not public), with scales searched over two peaks; our order saves twice its best";
const CARDS: &str = "a tenth of a card tree is some dozens of cards: more views, larger masks and per-leaf pivots brought less than .005 more";
const BILLBOARDS: &str = "planes through all of a crown turn more evenly than what is left of its own leaves, at the same mean Q";
const LARGE_TRIANGLES: &str =
    "at these shares 44 triangles of 8 m² are left: one of them is 2 % of the tree";
const FEW_RED: &str = "half of the cards are gone, and a card is all red or all green";
const SEASONS: &str = "576 nodes live through 10 seasons: turning nodes alone takes longer than the aim, a fiftieth of the print";
const NEIGHBOURS: &str = "37 of the 100 trees stand in each other's light and change, each about 1.3 ms on one core; a row of our own";
const PUU1: &str =
    "a circle through the scanned points of the trunk has 4.3 cm, where the reference says 3.7 cm";

/// The reason for a row that misses.
pub(super) fn reason(system: &str, case: &str, metric: &str) -> Option<&'static str> {
    REASONS
        .iter()
        .find(|(of, part, name, _)| *of == system && case.contains(part) && metric.contains(name))
        .map(|(.., why)| *why)
}
