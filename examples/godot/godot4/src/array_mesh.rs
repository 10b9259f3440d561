//! From the library's columns to Godot's own mesh.

use crate::material::material;
use crate::native::{Mesh, Packed, Result};
use godot::classes::ArrayMesh;
use godot::classes::mesh::{ArrayCustomFormat, ArrayFormat, ArrayType, PrimitiveType};
use godot::obj::{EngineBitfield, EngineEnum};
use godot::prelude::*;

const CUSTOMS: [(&str, ArrayType, ArrayFormat); 4] = [
    ("CUSTOM0", ArrayType::CUSTOM0, ArrayFormat::CUSTOM0_SHIFT),
    ("CUSTOM1", ArrayType::CUSTOM1, ArrayFormat::CUSTOM1_SHIFT),
    ("CUSTOM2", ArrayType::CUSTOM2, ArrayFormat::CUSTOM2_SHIFT),
    ("CUSTOM3", ArrayType::CUSTOM3, ArrayFormat::CUSTOM3_SHIFT),
];

/// A mesh with a surface and a material for each surface that has triangles.
pub(crate) fn array_mesh(mesh: &Mesh, light_map: bool, wind: bool) -> Result<Gd<ArrayMesh>> {
    let mut made = ArrayMesh::new_gd();
    for number in 0..mesh.n_surfaces()? {
        let surface = mesh.surface(number)?;
        // Leaf kinds that did not grow: Godot takes no empty surface.
        if surface.n_indices == 0 {
            continue;
        }
        let packed = mesh.pack(number)?;
        let arrays = arrays(&packed, light_map, wind)?;
        made.add_surface_from_arrays_ex(PrimitiveType::TRIANGLES, &arrays.upcast_any_array())
            .flags(custom_format(wind))
            .done();
        let last = made.get_surface_count() - 1;
        made.surface_set_material(last, &material(mesh, surface.material as usize)?);
    }
    Ok(made)
}

/// Says that the custom arrays are four floats each; nothing is compressed, as bark repeats far beyond 1.
fn custom_format(wind: bool) -> ArrayFormat {
    let mut bits = 0;
    if wind {
        for (_, _, shift) in CUSTOMS {
            bits |= (ArrayCustomFormat::RGBA_FLOAT.ord() as u64) << shift.ord();
        }
    }
    ArrayFormat::from_ord(bits)
}

fn arrays(packed: &Packed, light_map: bool, wind: bool) -> Result<VarArray> {
    let mut arrays = VarArray::new();
    arrays.resize(ArrayType::MAX.ord() as usize, &Variant::nil());
    let mut put = |at: ArrayType, column: Variant| arrays.set(at.ord() as usize, &column);

    put(ArrayType::VERTEX, vectors(packed.floats("POSITION")?).to_variant());
    put(ArrayType::NORMAL, vectors(packed.floats("NORMAL")?).to_variant());
    put(ArrayType::TANGENT, PackedFloat32Array::from(packed.floats("TANGENT")?).to_variant());
    put(ArrayType::TEX_UV, coordinates(packed.floats("UV")?).to_variant());
    if light_map {
        put(ArrayType::TEX_UV2, coordinates(packed.floats("UV2")?).to_variant());
    }
    if wind {
        for (name, at, _) in CUSTOMS {
            put(at, PackedFloat32Array::from(packed.floats(name)?).to_variant());
        }
    }
    put(ArrayType::INDEX, PackedInt32Array::from(packed.indices()?).to_variant());
    Ok(arrays)
}

fn vectors(floats: &[f32]) -> PackedVector3Array {
    let (rows, _) = floats.as_chunks::<3>();
    rows.iter().map(|&[x, y, z]| Vector3::new(x, y, z)).collect()
}

fn coordinates(floats: &[f32]) -> PackedVector2Array {
    let (rows, _) = floats.as_chunks::<2>();
    rows.iter().map(|&[x, y]| Vector2::new(x, y)).collect()
}
