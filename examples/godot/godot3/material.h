/* From the library's materials and pictures to Godot 3's. */
#ifndef BOTANICAL_TREE_MATERIAL_H
#define BOTANICAL_TREE_MATERIAL_H

#include <gdnative_api_struct.gen.h>
#include <tree.h>

/* Calls a method of an object, and destroys its arguments. */
void call_method(const godot_gdnative_core_api_struct *api, godot_object *object, const char *class_name,
                 const char *method, godot_variant *arguments, int n_arguments);

/* Makes a SpatialMaterial of a material of the mesh. `made`, which is nil before, holds its one reference. */
tree_status make_material(const godot_gdnative_core_api_struct *api, const tree_mesh *mesh, size_t number,
                          godot_variant *made);

#endif
