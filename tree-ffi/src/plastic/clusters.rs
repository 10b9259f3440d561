//! Leaf clusters and their light.

use super::analysis::tree_plastic;
use super::scene::{lock, tree_plastic_scene};
use crate::border::{
    Failure, Handle, TREE_ERROR_PARAMETER, call, free, get, out, out_value, tree_status,
};
use crate::mesh::column;
use tree_model::plastic::{Ball, Light, TreeId};

/// A leaf cluster: a ball that lets a share of the light through, and the light at its middle.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_cluster {
    /// Its middle in metres, in the tree's own frame.
    pub center: [f32; 3],
    /// In metres.
    pub radius: f32,
    /// Share of the light that comes through, 0 to 1.
    pub translucency: f32,
    /// Light at its middle, as a share of the open sky's, 0 to 1 times the brightness.
    pub light: f32,
    /// Unit vector towards where the light comes from on average; 0 where there is none.
    pub towards: [f32; 3],
    /// Tips of main branches that it is made of; 0 in a scene, where that is not told.
    pub n_tips: u32,
}

impl tree_plastic_cluster {
    fn of(ball: &Ball, light: &Light, n_tips: u32) -> Self {
        Self {
            center: ball.center.to_array(),
            radius: ball.radius,
            translucency: ball.translucency,
            light: light.amount,
            towards: light.direction.to_array(),
            n_tips,
        }
    }
}

/// The leaf clusters of a tree at one time: a copy.
pub struct tree_plastic_clusters(Vec<tree_plastic_cluster>);

impl Handle for tree_plastic_clusters {
    const NAME: &'static str = "tree_plastic_clusters";
}

/// The leaf clusters that a tree had in a season of its life in the open. `season` is below
/// `tree_plastic_report.n_seasons`. Free them with `tree_plastic_clusters_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_clusters_of_season(
    plastic: *const tree_plastic,
    season: u32,
    clusters: *mut *mut tree_plastic_clusters,
) -> tree_status {
    call(|| {
        let place = unsafe { out(clusters, "clusters") }?;
        let model = unsafe { get(plastic, "plastic") }?.rust();
        let n = model.report().n_seasons;
        if season >= n {
            let text = format!("season is {season}, but the tree lived {n} seasons, from 0");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let found = model.clusters(season);
        let row = |one: &tree_model::plastic::LeafCluster| {
            tree_plastic_cluster::of(&one.ball, &one.light, one.tips)
        };
        place.put(tree_plastic_clusters(found.iter().map(row).collect()));
        Ok(())
    })
}

/// The leaf clusters of a tree of a scene today, as of the last update; those that are gone are left out. Free them with
/// `tree_plastic_clusters_free`. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_clusters(
    scene: *const tree_plastic_scene,
    id: u64,
    clusters: *mut *mut tree_plastic_clusters,
) -> tree_status {
    call(|| {
        let place = unsafe { out(clusters, "clusters") }?;
        let found = unsafe { lock(scene) }?.scene.clusters(TreeId(id))?;
        let rows = found.iter().map(|(ball, light)| tree_plastic_cluster::of(ball, light, 0));
        place.put(tree_plastic_clusters(rows.collect()));
        Ok(())
    })
}

/// Views clusters: where the rows begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_clusters_view(
    clusters: *const tree_plastic_clusters,
    rows: *mut *const tree_plastic_cluster,
    n_rows: *mut usize,
) -> tree_status {
    call(|| {
        let clusters = &unsafe { get(clusters, "clusters") }?.0;
        unsafe { out_value(rows, column(clusters), "rows") }?;
        unsafe { out_value(n_rows, clusters.len(), "n_rows") }
    })
}

/// Frees clusters.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_clusters_free(
    clusters: *mut tree_plastic_clusters,
) -> tree_status {
    call(|| unsafe { free(clusters, "clusters") })
}
