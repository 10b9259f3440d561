"""Imports glTF, OBJ or PLY files with Blender and prints what it made of them.

    pip install bpy==5.0.1               (needs the Python it was built for: 3.11)
    python blender.py tree.glb [more ...]

or, with an installed Blender:

    blender --background --python blender.py -- tree.glb [more ...]

One line per file with counts, one per material with how it treats alpha. Exits with 1 when a file cannot
be imported or has no triangle.
"""

import sys

import bpy


def load(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    lower = path.lower()
    if lower.endswith((".glb", ".gltf")):
        bpy.ops.import_scene.gltf(filepath=path)
    elif lower.endswith(".obj"):
        bpy.ops.wm.obj_import(filepath=path)
    else:
        bpy.ops.wm.ply_import(filepath=path)


def alpha_mode(material):
    """Masks come as a comparison of alpha with the cutoff."""
    if material.node_tree is None:
        return "opaque"
    kinds = {node.type for node in material.node_tree.nodes}
    shader = next((n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED"), None)
    linked = shader is not None and shader.inputs["Alpha"].is_linked
    if not linked:
        return "opaque"
    return "mask" if "MATH" in kinds else "blend"


def describe(path):
    load(path)
    triangles = vertices = 0
    layers, attributes = 0, set()
    meshes = [o for o in bpy.data.objects if o.type == "MESH"]
    # What instancing draws is not in the list of objects.
    graph = bpy.context.evaluated_depsgraph_get()
    drawn = sum(1 for i in graph.object_instances if i.object.type == "MESH")
    for mesh in {o.data for o in meshes}:
        mesh.calc_loop_triangles()
        triangles += len(mesh.loop_triangles)
        vertices += len(mesh.vertices)
        layers = max(layers, len(mesh.uv_layers))
        attributes |= {a.name for a in mesh.attributes if not a.name.startswith(".")}
    print(
        f"{path}: {len(meshes)} objects, {drawn} drawn, {vertices} vertices, {triangles} triangles, "
        f"{len(bpy.data.materials)} materials, {len(bpy.data.images)} images, {layers} UV layers, "
        f"attributes {sorted(attributes)}"
    )
    for material in bpy.data.materials:
        culled = "one-sided" if material.use_backface_culling else "two-sided"
        print(f"  {material.name}: {alpha_mode(material)}, {culled}")
    return triangles > 0


def main():
    paths = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]
    print(f"Blender {bpy.app.version_string}")
    return all([describe(path) for path in paths]) and bool(paths)


sys.exit(0 if main() else 1)
