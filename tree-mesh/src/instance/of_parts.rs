//! Instanced trees of parts that come from elsewhere.

use super::{InstancedTree, InstancingReport, Twig, sizes};
use crate::error::{MeshError, Result};
use crate::mesh::Mesh;

impl InstancedTree {
    /// An instanced tree of parts of your own. Its report has the sizes; it stands for no tree, so `reach`
    /// and `deviation` are 0 and both numbers of leaves are its own.
    ///
    /// # Errors
    /// As [`InstancedTree::check`].
    ///
    /// # Complexity
    /// One pass over all columns.
    pub fn of_parts(base: Mesh, twigs: Vec<Twig>) -> Result<Self> {
        let mut made = Self { base, twigs, report: InstancingReport::default() };
        made.check()?;
        made.report = sizes(&made);
        Ok(made)
    }

    /// Checks the meshes, that twigs have as many surfaces as the base, that their columns have one length
    /// and finite numbers, rotations unit length and scales one positive factor, and that the branches that
    /// bear instances exist.
    ///
    /// # Errors
    /// As [`Mesh::check`]; [`MeshError::Instances`], naming the twig.
    pub fn check(&self) -> Result<()> {
        self.base.check()?;
        for (number, twig) in self.twigs.iter().enumerate() {
            twig.mesh.check()?;
            check_twig(number, twig, &self.base)?;
        }
        Ok(())
    }
}

fn check_twig(number: usize, twig: &Twig, base: &Mesh) -> Result<()> {
    let fail =
        |problem: String| Err(MeshError::Instances { name: format!("of twig {number}"), problem });
    let (found, needed) = (twig.mesh.surfaces.len(), base.surfaces.len());
    if found != needed {
        return fail(format!("{found} surfaces, the base has {needed}"));
    }
    let n = twig.translations.len();
    for (field, found) in [
        ("rotations", twig.rotations.len()),
        ("scales", twig.scales.len()),
        ("branches", twig.branches.len()),
    ] {
        if found != n {
            return fail(format!("{found} {field}, {n} translations"));
        }
    }
    if let Some(row) = twig.translations.iter().position(|at| !at.is_finite()) {
        return fail(format!("translation {row} is not finite"));
    }
    let unit = |turn: &glam::Quat| (turn.length_squared() - 1.0).abs() <= 0.01;
    if let Some(row) = twig.rotations.iter().position(|turn| !unit(turn)) {
        return fail(format!("rotation {row} is not of unit length"));
    }
    let even = |s: &glam::Vec3| s.is_finite() && s.x > 0.0 && s.x == s.y && s.x == s.z;
    if let Some(row) = twig.scales.iter().position(|scale| !even(scale)) {
        return fail(format!("scale {row} is not one positive factor for all axes"));
    }
    let known = base.branches.len();
    let missing = |&branch: &u32| branch as usize >= known;
    match twig.branches.iter().position(missing) {
        Some(row) if !twig.mesh.branches.is_empty() => {
            fail(format!("branch {} of row {row} does not exist in the base", twig.branches[row]))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build;
    use crate::{Look, MeshParams};
    use glam::{Quat, Vec3};
    use tree_core::{Control, Skeleton, Species, Tree};

    fn rod(length: f32) -> Mesh {
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
        builder.add(0, Vec3::Y * length, 0.05).unwrap();
        let tree = Tree::bare(builder.finish(), Species::default());
        let look = Look::plain(tree.species());
        build(&tree, &look, &MeshParams::default(), &Control::default()).unwrap().mesh
    }

    fn twig() -> Twig {
        Twig {
            mesh: rod(0.5),
            translations: vec![Vec3::Y, Vec3::Y * 2.0],
            rotations: vec![Quat::IDENTITY, Quat::from_rotation_z(1.0)],
            scales: vec![Vec3::ONE, Vec3::splat(0.5)],
            branches: vec![0, 0],
        }
    }

    #[test]
    fn parts_make_a_tree_with_its_sizes() {
        let made = InstancedTree::of_parts(rod(3.0), vec![twig()]).unwrap();
        assert_eq!((made.report.n_twigs, made.report.n_instances), (1, 2));
        let bytes = |mesh: &Mesh| super::super::bytes(mesh);
        assert_eq!(made.report.bytes_flat, bytes(&rod(3.0)) + 2 * bytes(&rod(0.5)));
        let flat = made.flatten(&Control::default()).unwrap();
        assert_eq!(flat.n_triangles(), rod(3.0).n_triangles() + 2 * rod(0.5).n_triangles());
        assert_eq!(flat.branches.len(), 3);
    }

    #[test]
    fn what_does_not_fit_is_named() {
        let error = |change: fn(&mut Twig)| {
            let mut twig = twig();
            change(&mut twig);
            InstancedTree::of_parts(rod(3.0), vec![twig]).unwrap_err().to_string()
        };
        assert!(error(|t| t.rotations.truncate(1)).contains("1 rotations, 2 translations"));
        assert!(error(|t| t.translations[1].x = f32::NAN).contains("translation 1"));
        assert!(error(|t| t.rotations[0].w = f32::NAN).contains("rotation 0"));
        assert!(error(|t| t.scales[1].y = 2.0).contains("scale 1"));
        assert!(error(|t| t.branches[1] = 1).contains("branch 1 of row 1"));
        assert!(error(|t| t.mesh.surfaces.truncate(1)).contains("surfaces"));
        assert!(error(|t| t.mesh.branches[0].parent = 1).contains("branch 0"));
    }
}
