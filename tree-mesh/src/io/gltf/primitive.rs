//! One primitive of a document as a surface, once or many times.

use super::accessor::{Column, Columns};
use super::container::malformed;
use super::document::Primitive;
use super::look::Looks;
use crate::error::{MeshError, Result};
use crate::io::import::{Beside, Budget, ImportReport, Note};
use crate::io::normals;
use crate::mesh::{Mesh, Surface};
use glam::{Affine3A, Mat3A, Vec2, Vec3, Vec3A, Vec4};
use tree_core::Control;

const TRIANGLES: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

/// A document on its way into a mesh.
pub(super) struct Reader<'a> {
    pub(super) columns: Columns<'a>,
    pub(super) looks: Looks<'a>,
    pub(super) beside: Beside<'a>,
    pub(super) budget: Budget,
    pub(super) mesh: Mesh,
    pub(super) report: ImportReport,
    pub(super) control: &'a Control,
}

impl Reader<'_> {
    /// Adds the primitives of a mesh, each copied to every one of `places`.
    pub(super) fn mesh(&mut self, number: usize, places: &[Affine3A]) -> Result<()> {
        let document = self.columns.document;
        let mesh = document
            .meshes
            .get(number)
            .ok_or_else(|| malformed(format!("mesh {number}"), "does not exist"))?;
        for (index, primitive) in mesh.primitives.iter().enumerate() {
            self.control.check()?;
            let place = || format!("mesh {number}, primitive {index}");
            if let Some(surface) = self.surface(primitive, places.len() as u64, &place)? {
                let surface = spread(surface, places);
                self.mesh.surfaces.push(surface);
            }
        }
        Ok(())
    }

    /// A primitive where it is drawn without a transform. `None` when it has no triangles.
    fn surface(
        &mut self,
        primitive: &Primitive,
        n_copies: u64,
        place: &dyn Fn() -> String,
    ) -> Result<Option<Surface>> {
        if primitive.extensions.as_ref().is_some_and(|all| all.draco.is_some()) {
            let what = "KHR_draco_mesh_compression".into();
            return Err(MeshError::Unsupported { format: "glTF", what });
        }
        let skip = |note| (Ok(None), note);
        let (skipped, note) = match (primitive.mode, primitive.attributes.get("POSITION")) {
            (..TRIANGLES, _) => skip(Note::PointsOrLines),
            (TRIANGLES | STRIP | FAN, Some(&positions)) => {
                return self.triangles(primitive, positions, n_copies, place);
            }
            (TRIANGLES | STRIP | FAN, None) => skip(Note::NoPositions),
            (mode, _) => return Err(malformed(place(), format!("mode {mode}"))),
        };
        self.report.note(note);
        self.budget.take(0, 0, &self.control.limits)?;
        skipped
    }

    fn triangles(
        &mut self,
        primitive: &Primitive,
        positions: usize,
        n_copies: u64,
        place: &dyn Fn() -> String,
    ) -> Result<Option<Surface>> {
        let positions = self.columns.get(positions)?;
        let indices = primitive.indices.map(|indices| self.columns.get(indices)).transpose()?;
        let n = positions.len();
        let n_corners = indices.as_ref().map_or(n, Column::len);
        let n_triangles =
            if primitive.mode == TRIANGLES { n_corners / 3 } else { n_corners.saturating_sub(2) };
        self.budget.take(
            (n_triangles as u64).max(1).saturating_mul(n_copies),
            (n as u64).saturating_mul(n_copies),
            &self.control.limits,
        )?;
        if u64::from(u32::MAX) <= (n as u64).saturating_mul(n_copies) {
            return Err(MeshError::TooManyVertices {
                surface: Some(self.mesh.surfaces.len()),
                found: (n as u64).saturating_mul(n_copies),
                max: u64::from(u32::MAX) - 1,
            });
        }
        let corners = match indices {
            Some(indices) => indices.indices()?,
            None => (0..n as u32).collect(),
        };
        if let Some(&found) = corners.iter().find(|&&corner| corner as usize >= n) {
            return Err(malformed(place(), format!("index {found}, there are {n} vertices")));
        }
        let partial = corners.len() > 3 * n_triangles && primitive.mode == TRIANGLES;
        self.report.note_times(Note::PartialFaces, u64::from(partial));
        if n_triangles == 0 {
            return Ok(None);
        }
        let (material, uv_use) = self.looks.show(
            primitive.material,
            &mut self.beside,
            &mut self.report,
            self.control,
        )?;
        let mut surface = Surface {
            positions: vectors::<3, _>(&positions)?,
            indices: assemble(primitive.mode, corners),
            material,
            ..Default::default()
        };
        if let Some(row) = surface.positions.iter().position(|v| !v.is_finite()) {
            return Err(malformed(place(), format!("position {row} is not finite")));
        }
        self.normals(primitive, &mut surface)?;
        surface.uvs = match self.texture_coordinates(primitive, uv_use.set, n)? {
            Some(uvs) => uvs,
            None => {
                self.report.note(Note::UvsMissing);
                vec![Vec2::ZERO; n]
            }
        };
        uv_use.apply(&mut surface.uvs);
        if uv_use.set == 0 {
            surface.uvs2 = self.texture_coordinates(primitive, 1, n)?.unwrap_or_default();
        }
        if let Some(shades) = self.attribute(primitive, "_OCCLUSION", n)? {
            surface.occlusion = shades.vectors::<1>()?.into_iter().map(|[shade]| shade).collect();
        }
        let has = |name| u64::from(primitive.attributes.contains_key(name));
        self.report.note_times(Note::VertexColors, has("COLOR_0"));
        self.report.note_times(Note::Deformations, u64::from(primitive.targets.is_some()));
        Ok(Some(surface))
    }

    fn normals(&mut self, primitive: &Primitive, surface: &mut Surface) -> Result<()> {
        let n = surface.positions.len();
        match self.attribute(primitive, "NORMAL", n)? {
            Some(column) => {
                surface.normals = vectors::<3, _>(&column)?;
                self.report.note_times(Note::NormalsRepaired, normals::repair(surface));
                if let Some(column) = self.attribute(primitive, "TANGENT", n)? {
                    surface.tangents = vectors::<4, _>(&column)?;
                    surface.tangents.iter_mut().for_each(|tangent| *tangent = unit(*tangent));
                }
            }
            None => {
                self.report.note(Note::NormalsComputed);
                normals::compute(surface);
            }
        }
        Ok(())
    }

    fn texture_coordinates(
        &self,
        primitive: &Primitive,
        set: u32,
        n: usize,
    ) -> Result<Option<Vec<Vec2>>> {
        let column = self.attribute(primitive, &format!("TEXCOORD_{set}"), n)?;
        column.map(|column| vectors::<2, _>(&column)).transpose()
    }

    /// A column of `n` rows.
    fn attribute(&self, primitive: &Primitive, name: &str, n: usize) -> Result<Option<Column<'_>>> {
        let Some(&number) = primitive.attributes.get(name) else { return Ok(None) };
        let column = self.columns.get(number)?;
        if column.len() == n {
            return Ok(Some(column));
        }
        Err(malformed(
            format!("accessor {number}"),
            format!("{} rows of {name}, there are {n} positions", column.len()),
        ))
    }
}

fn vectors<const N: usize, T: From<[f32; N]>>(column: &Column<'_>) -> Result<Vec<T>> {
    Ok(column.vectors::<N>()?.into_iter().map(T::from).collect())
}

/// A tangent of unit length with a sign of 1; one without direction points along x.
fn unit(tangent: Vec4) -> Vec4 {
    let direction = tangent.truncate();
    let sign = if tangent.w < 0.0 { -1.0 } else { 1.0 };
    if (direction.length_squared() - 1.0).abs() <= 1e-3 {
        return direction.extend(sign);
    }
    normals::unit(direction).unwrap_or(Vec3::X).extend(sign)
}

/// Corners in the order of the primitive as single triangles, all turning the same way.
fn assemble(mode: u32, mut corners: Vec<u32>) -> Vec<u32> {
    match mode {
        TRIANGLES => {
            corners.truncate(corners.len() / 3 * 3);
            corners
        }
        STRIP => corners
            .windows(3)
            .enumerate()
            .flat_map(|(i, w)| if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[0], w[2], w[1]] })
            .collect(),
        _ => match corners.split_first() {
            Some((&center, rim)) => {
                rim.windows(2).flat_map(|edge| [edge[0], edge[1], center]).collect()
            }
            None => Vec::new(),
        },
    }
}

/// Copies a surface to every place.
fn spread(surface: Surface, places: &[Affine3A]) -> Surface {
    if let [place] = places {
        let mut surface = surface;
        if *place != Affine3A::IDENTITY {
            let indices = std::mem::take(&mut surface.indices);
            let (positions, directions, tangents) = (
                std::mem::take(&mut surface.positions),
                std::mem::take(&mut surface.normals),
                std::mem::take(&mut surface.tangents),
            );
            let source =
                Surface { positions, normals: directions, tangents, indices, ..Surface::default() };
            append(&source, *place, &mut surface);
        }
        return surface;
    }
    let n = places.len();
    let mut all = Surface {
        positions: Vec::with_capacity(n * surface.positions.len()),
        normals: Vec::with_capacity(n * surface.normals.len()),
        tangents: Vec::with_capacity(n * surface.tangents.len()),
        indices: Vec::with_capacity(n * surface.indices.len()),
        uvs: surface.uvs.repeat(n),
        uvs2: surface.uvs2.repeat(n),
        occlusion: surface.occlusion.repeat(n),
        material: surface.material,
        ..Default::default()
    };
    for &place in places {
        append(&surface, place, &mut all);
    }
    all
}

/// Adds positions, normals, tangents and triangles, moved to their place.
fn append(source: &Surface, place: Affine3A, to: &mut Surface) {
    let first = to.positions.len() as u32;
    let linear = place.matrix3;
    let mirrors = linear.determinant() < 0.0;
    let sign = if mirrors { -1.0 } else { 1.0 };
    // Normals go with the cofactors: the inverse transposed, without a division by the determinant.
    let cofactors = Mat3A::from_cols(
        linear.y_axis.cross(linear.z_axis),
        linear.z_axis.cross(linear.x_axis),
        linear.x_axis.cross(linear.y_axis),
    );
    to.positions.extend(source.positions.iter().map(|&p| place.transform_point3(p)));
    to.normals.extend(source.normals.iter().map(|&n| {
        let turned = Vec3::from(cofactors * Vec3A::from(n)) * sign;
        normals::unit(turned).unwrap_or(n)
    }));
    to.tangents.extend(source.tangents.iter().map(|&t| {
        let turned = Vec3::from(linear * Vec3A::from(t.truncate()));
        normals::unit(turned).unwrap_or(t.truncate()).extend(t.w * sign)
    }));
    to.indices.extend(source.indices.chunks_exact(3).flat_map(|corners| {
        let [a, b, c] = [corners[0] + first, corners[1] + first, corners[2] + first];
        if mirrors { [a, c, b] } else { [a, b, c] }
    }));
}
