//! The C functions, and owners of what they make. What a C++ plug-in would have in its header.

use std::fmt;
use std::ptr::{null, null_mut};
use tree_ffi::*;

/// A call failed: the library's text.
#[derive(Debug)]
pub(crate) struct Failure(String);

impl Failure {
    pub(crate) fn new(text: impl Into<String>) -> Self {
        Self(text.into())
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

pub(crate) type Result<T> = std::result::Result<T, Failure>;

fn check(status: tree_status) -> Result<()> {
    if status == TREE_OK {
        return Ok(());
    }
    // SAFETY: never NULL, ends with a NUL, and stays until the next failure in this thread.
    let text = unsafe { std::ffi::CStr::from_ptr(tree_error_text()) };
    Err(Failure(text.to_string_lossy().into_owned()))
}

/// What the node lets people choose.
pub(crate) struct Options {
    pub(crate) leaf_scale: f32,
    pub(crate) error: f32,
    pub(crate) light_map: bool,
}

/// Owns a `tree_tree`.
pub(crate) struct Tree(*mut tree_tree);

impl Tree {
    pub(crate) fn grow(preset: &str, seed: u64) -> Result<Self> {
        let mut params = std::mem::MaybeUninit::<tree_path_params>::uninit();
        let size = size_of::<tree_path_params>();
        let mut tree = null_mut();
        // SAFETY: the text has its length, the struct its size, and both places are ours. After
        // success the parameters are filled.
        unsafe {
            let name = preset.as_ptr().cast();
            check(tree_path_preset(name, preset.len(), params.as_mut_ptr(), size))?;
            check(tree_path_grow(params.as_ptr(), seed, null(), null_mut(), &mut tree))?;
        }
        Ok(Self(tree))
    }
}

impl Drop for Tree {
    fn drop(&mut self) {
        // SAFETY: ours, and freed once.
        unsafe { tree_tree_free(self.0) };
    }
}

/// Owns a `tree_mesh`.
pub(crate) struct Mesh(*mut tree_mesh);

impl Mesh {
    pub(crate) fn build(tree: &Tree, options: &Options) -> Result<Self> {
        let mut params = std::mem::MaybeUninit::<tree_mesh_params>::uninit();
        let mut mesh = null_mut();
        // SAFETY: as in `Tree::grow`.
        unsafe {
            check(tree_mesh_params_init(params.as_mut_ptr(), size_of::<tree_mesh_params>()))?;
            let params = params.assume_init_mut();
            params.leaf_scale = options.leaf_scale;
            params.error = options.error;
            params.tangents = 1;
            params.lightmap = options.light_map.into();
            check(tree_mesh_build(tree.0, null(), params, null(), null_mut(), &mut mesh))?;
        }
        Ok(Self(mesh))
    }

    pub(crate) fn n_surfaces(&self) -> Result<usize> {
        let mut n = 0;
        // SAFETY: alive, and a place of ours.
        check(unsafe { tree_mesh_surface_count(self.0, &mut n) })?;
        Ok(n)
    }

    /// A surface's columns, where they lie; they are read through [`column`] only.
    pub(crate) fn surface(&self, number: usize) -> Result<tree_surface> {
        let mut surface = std::mem::MaybeUninit::<tree_surface>::zeroed();
        // SAFETY: zeros are valid for numbers and pointers; the library fills the rest in.
        unsafe {
            let surface = surface.assume_init_mut();
            surface.struct_size = size_of::<tree_surface>();
            check(tree_mesh_surface(self.0, number, surface))?;
            Ok(*surface)
        }
    }

    pub(crate) fn material(&self, number: usize) -> Result<tree_material> {
        let mut material = std::mem::MaybeUninit::<tree_material>::zeroed();
        // SAFETY: as in `surface`.
        unsafe {
            let material = material.assume_init_mut();
            material.struct_size = size_of::<tree_material>();
            check(tree_mesh_material(self.0, number, material))?;
            Ok(*material)
        }
    }

    /// The picture of a material; none where it has none.
    pub(crate) fn texture(&self, number: usize) -> Result<Option<Texture>> {
        let mut texture = null_mut();
        // SAFETY: alive, and a place of ours.
        check(unsafe { tree_mesh_texture(self.0, number, &mut texture) })?;
        Ok((!texture.is_null()).then_some(Texture(texture)))
    }

    /// A surface in Godot's layout.
    pub(crate) fn pack(&self, number: usize) -> Result<Packed> {
        let mut packed = null_mut();
        // SAFETY: alive, and a place of ours.
        check(unsafe { tree_mesh_pack(self.0, number, TREE_LAYOUT_GODOT, null(), &mut packed) })?;
        Ok(Packed(packed))
    }
}

impl Drop for Mesh {
    fn drop(&mut self) {
        // SAFETY: ours, and freed once.
        unsafe { tree_mesh_free(self.0) };
    }
}

/// Owns a `tree_texture`.
pub(crate) struct Texture(*mut tree_texture);

impl Texture {
    /// Width, height, and red, green, blue and alpha of each pixel.
    pub(crate) fn pixels(&self) -> Result<(u32, u32, &[u8])> {
        let mut pixels = std::mem::MaybeUninit::<tree_texture_pixels>::zeroed();
        // SAFETY: as in `Mesh::surface`; the pixels live as long as the handle.
        unsafe {
            let pixels = pixels.assume_init_mut();
            pixels.struct_size = size_of::<tree_texture_pixels>();
            check(tree_texture_view(self.0, pixels))?;
            let n = 4 * pixels.width as usize * pixels.height as usize;
            Ok((pixels.width, pixels.height, column(self, pixels.pixels, n)))
        }
    }
}

impl Drop for Texture {
    fn drop(&mut self) {
        // SAFETY: ours, and freed once.
        unsafe { tree_texture_free(self.0) };
    }
}

/// Owns a `tree_packed`.
pub(crate) struct Packed(*mut tree_packed);

impl Packed {
    fn columns(&self) -> Result<tree_packed_columns> {
        let mut columns = std::mem::MaybeUninit::<tree_packed_columns>::zeroed();
        // SAFETY: as in `Mesh::surface`.
        unsafe {
            let columns = columns.assume_init_mut();
            columns.struct_size = size_of::<tree_packed_columns>();
            check(tree_packed_view(self.0, columns))?;
            Ok(*columns)
        }
    }

    /// The stream of this name, which must be of floats.
    pub(crate) fn floats(&self, name: &str) -> Result<&[f32]> {
        let columns = self.columns()?;
        // SAFETY: the view says how many streams there are and how long each is, and lives as long as
        // the handle.
        unsafe {
            for stream in column(self, columns.streams, columns.n_streams) {
                let found = column(self, stream.name.data.cast::<u8>(), stream.name.len);
                if found == name.as_bytes() && stream.number == TREE_NUMBER_F32 {
                    return Ok(column(self, stream.data.cast(), stream.n_bytes / size_of::<f32>()));
                }
            }
        }
        Err(Failure::new(format!("the layout has no stream {name} of floats")))
    }

    /// Corners of triangles, clockwise as Godot's front faces.
    pub(crate) fn indices(&self) -> Result<Vec<i32>> {
        let columns = self.columns()?;
        let n = columns.n_indices;
        // SAFETY: as in `floats`. No mesh has 2³¹ vertices.
        unsafe {
            Ok(match columns.index_bytes {
                2 => column(self, columns.indices.cast::<u16>(), n)
                    .iter()
                    .map(|&i| i.into())
                    .collect(),
                _ => column(self, columns.indices.cast::<i32>(), n).to_vec(),
            })
        }
    }
}

impl Drop for Packed {
    fn drop(&mut self) {
        // SAFETY: ours, and freed once.
        unsafe { tree_packed_free(self.0) };
    }
}

/// `n` elements from `data` on, as long as their owner lives; none for NULL.
///
/// # Safety
/// `data` is NULL or points at as many elements, which belong to `_owner`.
pub(crate) unsafe fn column<O, T>(_owner: &O, data: *const T, n: usize) -> &[T] {
    if data.is_null() || n == 0 {
        return &[];
    }
    unsafe { std::slice::from_raw_parts(data, n) }
}

/// What Godot is handed, without Godot: `cargo test` needs no engine.
#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_oak_comes_in_godots_layout() {
        let tree = Tree::grow("oak", 1).unwrap();
        let mesh = Mesh::build(&tree, &Options { leaf_scale: 1.0, error: 0.01, light_map: true });
        let mesh = mesh.unwrap();
        drop(tree);
        assert_eq!(mesh.n_surfaces().unwrap(), 2);
        for number in 0..2 {
            let surface = mesh.surface(number).unwrap();
            let packed = mesh.pack(number).unwrap();
            let n = surface.n_vertices;
            let wide = [("POSITION", 3), ("NORMAL", 3), ("TANGENT", 4), ("UV", 2), ("UV2", 2)];
            let custom = ["CUSTOM0", "CUSTOM1", "CUSTOM2", "CUSTOM3"].map(|name| (name, 4));
            for (name, width) in wide.into_iter().chain(custom) {
                assert_eq!(packed.floats(name).unwrap().len(), n * width, "{name}");
            }
            let indices = packed.indices().unwrap();
            assert_eq!(indices.len(), surface.n_indices);
            assert!(indices.iter().all(|&index| (0..n as i32).contains(&index)));
            // SAFETY: a view of a mesh that is alive.
            let ours = unsafe { column(&mesh, surface.indices, 3) };
            assert_eq!(indices[..3], [ours[0], ours[2], ours[1]].map(|index| index as i32));

            let (width, height, pixels) = {
                let texture = mesh.texture(surface.material as usize).unwrap().unwrap();
                let (width, height, pixels) = texture.pixels().unwrap();
                (width as usize, height as usize, pixels.to_vec())
            };
            assert_eq!(pixels.len(), 4 * width * height);
        }
        drop(mesh);
        assert_eq!(tree_live_objects(), 0);
        let Err(failure) = Tree::grow("yggdrasil", 1) else { panic!("no such preset") };
        assert!(failure.to_string().contains("yggdrasil"), "{failure}");
    }
}
