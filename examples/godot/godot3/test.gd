# Builds the oak in Godot and holds its ArrayMesh against what the C side saw.
# Run it by run.sh: a script that fails to load leaves Godot waiting for ever.
extends SceneTree

var failures = 0

func check(holds, what):
	if not holds:
		failures += 1
		print("does not hold: ", what)

func _initialize():
	var trees = load("res://botanical_tree.gdns").new()
	var mesh = trees.grow("oak", 1)
	check(mesh is ArrayMesh, "an ArrayMesh: " + trees.error())
	if mesh is ArrayMesh:
		compare(mesh, trees.facts().split("\n"))

	check(trees.grow("yggdrasil", 1) == null, "no tree of a preset that is none")
	check(trees.error().find("TREE_ERROR_UNKNOWN_NAME") == 0, "its error: " + trees.error())
	check(trees.error().find("yggdrasil") > 0, "the name in the error: " + trees.error())
	check(trees.live_objects() == 0, "nothing is left alive")
	print("TREE TEST ", "FAILED" if failures > 0 else "PASSED")
	quit(1 if failures > 0 else 0)

func compare(mesh, facts):
	# One line for each surface, and the hashes.
	check(mesh.get_surface_count() == facts.size() - 1, "as many surfaces as C has")
	check(mesh.get_surface_count() >= 2, "bark and leaves")
	var whole = null
	for i in range(mesh.get_surface_count()):
		var said = facts[i].split(" ")
		var arrays = mesh.surface_get_arrays(i)
		var vertices = arrays[Mesh.ARRAY_VERTEX]
		check(vertices.size() == int(said[1]), "vertices of surface %d" % i)
		check(arrays[Mesh.ARRAY_INDEX].size() == int(said[2]), "indices of surface %d" % i)
		check(arrays[Mesh.ARRAY_NORMAL].size() == int(said[1]), "normals of surface %d" % i)
		check(arrays[Mesh.ARRAY_TEX_UV].size() == int(said[1]), "uvs of surface %d" % i)
		var low = Vector3(float(said[3]), float(said[4]), float(said[5]))
		var high = Vector3(float(said[6]), float(said[7]), float(said[8]))
		var box = AABB(low, high - low)
		check(near(around(vertices), box), "bounds of the vertices of surface %d" % i)
		check(front(arrays), "front faces of surface %d look outwards" % i)
		dressed(mesh.surface_get_material(i), i > 0)
		whole = box if whole == null else whole.merge(box)
		print("surface %d: %d vertices, %d indices" % [i, vertices.size(), int(said[2])])
	check(near(mesh.get_aabb(), whole), "%s should be %s" % [mesh.get_aabb(), whole])
	check(whole.size.y > 2.0, "a tree's height")
	print("oak seed 1")
	print(facts[facts.size() - 1])

func dressed(material, leaf):
	check(material is SpatialMaterial, "a material")
	if not material is SpatialMaterial:
		return
	var picture = material.albedo_texture
	check(picture != null and picture.get_width() >= 256 and picture.get_height() >= 256, "a picture")
	check(material.albedo_color.r > 0.05 and material.albedo_color.a == 1.0, "a colour")
	check(material.roughness > 0.3 and material.roughness <= 1.0, "rough")
	check(material.params_use_alpha_scissor == leaf, "leaves are cut out, bark is not")
	check((material.params_cull_mode == SpatialMaterial.CULL_DISABLED) == leaf, "leaves have two sides")
	check(material.transmission_enabled == leaf, "light shines through leaves")
	if leaf:
		check(material.params_alpha_scissor_threshold == 0.5, "where they are cut out")

func around(vertices):
	var box = AABB(vertices[0], Vector3())
	for vertex in vertices:
		box = box.expand(vertex)
	return box

func near(a, b):
	return (a.position - b.position).length() < 1e-3 and (a.size - b.size).length() < 1e-3

# Clockwise from outside: the cross product of most triangles opposes their normals.
func front(arrays):
	var vertices = arrays[Mesh.ARRAY_VERTEX]
	var normals = arrays[Mesh.ARRAY_NORMAL]
	var indices = arrays[Mesh.ARRAY_INDEX]
	var opposed = 0
	var n = 0
	for i in range(0, indices.size() - 2, 3 * 97):
		var a = vertices[indices[i]]
		var normal = (vertices[indices[i + 1]] - a).cross(vertices[indices[i + 2]] - a)
		n += 1
		if normal.dot(normals[indices[i]]) < 0:
			opposed += 1
	return opposed * 2 > n
