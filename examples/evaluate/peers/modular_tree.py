"""modular-tree: a trunk with branches, and its manifold mesher, as the add-on's quick generation has them.

Usage: modular_tree.py PRESET SECONDS BARK.ply, with PRESET one of default, oak, pine, willow.
Prints one line of JSON. Leaves with status 3 where modular-tree or numpy is not installed.
"""

import sys
import time

from common import absent, answer, fastest

try:
    import m_tree
    import numpy as np
except ImportError as error:
    absent(error)

# Sides and smoothing of the add-on.
SIDES, SMOOTHING = 32, 4
# Of all its presets.
COMMON = {"break_chance": 0.02, "resolution": 3.0, "distribution.start": 0.1, "distribution.end": 0.95,
          "split.probability": 0.5, "start_radius": 0.4, "randomness": 0.5}
# In this order.
NAMES = ["length", "distribution.density", "start_angle", "gravity.strength", "gravity.up_attraction", "flatness",
         "gravity.stiffness"]
PRESETS = {
    "default": None,
    "oak": [12, 3, 60, 15, 0.3, 0.3, 0.15],
    "pine": [6, 4, 80, 2, 0.8, 0.1, 0.3],
    "willow": [15, 5, 45, 30, -0.2, 0.2, 0.02],
}
# Given as functions of the place along the branch.
PROPERTIES = {"length", "start_radius", "randomness", "start_angle"}


def put(branches, name, value):
    *path, last = name.split(".")
    for part in path:
        branches = getattr(branches, part)
    if last in PROPERTIES:
        value = m_tree.PropertyWrapper(m_tree.ConstantProperty(float(value)))
    setattr(branches, last, value)


def grow():
    trunk, branches = m_tree.TrunkFunction(), m_tree.BranchFunction()
    trunk.seed, branches.seed = 1, 2
    if PRESETS[preset] is not None:
        for name, value in {**COMMON, **dict(zip(NAMES, PRESETS[preset]))}.items():
            put(branches, name, value)
    trunk.add_child(branches)
    tree = m_tree.Tree()
    tree.set_trunk_function(trunk)
    tree.execute_functions()
    return tree


def mesh():
    """The whole work; the fastest time of the mesher alone is kept beside."""
    global mesh_seconds
    tree = grow()
    start = time.perf_counter()
    mesher = m_tree.ManifoldMesher()
    mesher.radial_n_points, mesher.smooth_iterations = SIDES, SMOOTHING
    made = mesher.mesh_tree(tree)
    mesh_seconds = min(mesh_seconds, time.perf_counter() - start)
    return made


preset, within, out = sys.argv[1], float(sys.argv[2]), sys.argv[3]
mesh_seconds = float("inf")
seconds, made, used = fastest(within, mesh)
points = np.asarray(made.get_vertices(), dtype="<f4").reshape(-1, 3)
quads = np.asarray(made.get_polygons()).reshape(-1, 4)
faces = np.zeros(len(quads), dtype=[("n", "u1"), ("corners", "<i4", 4)])
faces["n"], faces["corners"] = 4, quads
with open(out, "wb") as file:
    file.write(
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n".encode()
    )
    file.write(points.tobytes())
    file.write(faces.tobytes())
answer(seconds=seconds, mesh_seconds=mesh_seconds, leaf_triangles=0, peak_bytes=used)
