// Meshes: surfaces, materials, files, pictures.
using System;
using TreeFamily.Native;

namespace TreeFamily
{
    /// <summary>Surfaces with their materials.</summary>
    public sealed unsafe class TreeMesh : TreeHandle
    {
        /// <summary>Takes over what a call of your own made.</summary>
        public TreeMesh(tree_mesh* made)
        {
            Own(made);
        }

        /// <summary>Number of surfaces: 0 is the bark, 1 + k the leaves of kind k. Some may be empty.</summary>
        public int SurfaceCount
        {
            get
            {
                using (var call = new NativeCall())
                {
                    UIntPtr count;
                    call.Check(TreeNative.tree_mesh_surface_count(
                        (tree_mesh*)call.Use(this), &count));
                    return (int)count;
                }
            }
        }

        /// <summary>A surface, copied: it outlives the mesh.</summary>
        public TreeSurface Surface(int number)
        {
            using (var call = new NativeCall())
            {
                var view = new tree_surface { struct_size = (UIntPtr)sizeof(tree_surface) };
                call.Check(TreeNative.tree_mesh_surface(
                    (tree_mesh*)call.Use(this), Size(number), &view));
                return new TreeSurface(view);
            }
        }

        /// <summary>The box around all vertices, in metres: its lower corner, then its upper one.</summary>
        public float[] Bounds()
        {
            using (var call = new NativeCall())
            {
                var found = new tree_bounds { struct_size = (UIntPtr)sizeof(tree_bounds) };
                call.Check(TreeNative.tree_mesh_bounds((tree_mesh*)call.Use(this), &found));
                return new[]
                {
                    found.min[0], found.min[1], found.min[2],
                    found.max[0], found.max[1], found.max[2],
                };
            }
        }

        /// <summary>A material, with its picture copied; TreeSurface.Material is its number.</summary>
        public TreeMaterial Material(int number)
        {
            using (var call = new NativeCall())
            {
                var mesh = (tree_mesh*)call.Use(this);
                var view = new tree_material { struct_size = (UIntPtr)sizeof(tree_material) };
                call.Check(TreeNative.tree_mesh_material(mesh, Size(number), &view));
                var material = new TreeMaterial(view);
                tree_texture* texture;
                call.Check(TreeNative.tree_mesh_texture(mesh, Size(number), &texture));
                if (texture != null)
                {
                    using (var handle = new TextureHandle(texture))
                    {
                        var pixels = new tree_texture_pixels
                        {
                            struct_size = (UIntPtr)sizeof(tree_texture_pixels)
                        };
                        call.Check(TreeNative.tree_texture_view(texture, &pixels));
                        material.CopyPixels(pixels);
                    }
                }
                return material;
            }
        }

        /// <summary>A surface in an engine's layout and axes: TreeNative.TREE_LAYOUT_.</summary>
        public TreePacked Pack(int surface, int layout, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_packed* made;
                call.Check(TreeNative.tree_mesh_pack(
                    (tree_mesh*)call.Use(this), Size(surface), checked((uint)layout), call.Control,
                    &made));
                try
                {
                    return new TreePacked(call, made);
                }
                finally
                {
                    TreeNative.tree_packed_free(made);
                }
            }
        }

        /// <summary>
        /// Reads a glTF, GLB, OBJ or PLY file. It may come from anyone; files that it names are read only
        /// where the options say so.
        /// </summary>
        public static TreeMesh Read(
            string path, tree_import_options? parameters = null, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_import_options given = parameters.GetValueOrDefault();
                tree_mesh* made;
                call.Check(TreeNative.tree_mesh_read(
                    call.Text(path), TreeNative.TREE_NUL_TERMINATED,
                    parameters.HasValue ? &given : null, call.Control, null, &made));
                return new TreeMesh(made);
            }
        }

        /// <summary>Writes a GLB file, whole or not at all.</summary>
        public void WriteGlb(
            string path, tree_glb_options? parameters = null, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_glb_options given = parameters.GetValueOrDefault();
                call.Check(TreeNative.tree_mesh_write_glb(
                    (tree_mesh*)call.Use(this), call.Text(path), TreeNative.TREE_NUL_TERMINATED,
                    parameters.HasValue ? &given : null, call.Control));
            }
        }

        /// <summary>A GLB file in memory.</summary>
        public byte[] ToGlb(tree_glb_options? parameters = null, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_glb_options given = parameters.GetValueOrDefault();
                tree_bytes* made;
                call.Check(TreeNative.tree_mesh_to_glb(
                    (tree_mesh*)call.Use(this), parameters.HasValue ? &given : null, call.Control,
                    &made));
                return call.Take(made);
            }
        }

        /// <summary>A picture of the mesh, as a PNG file in memory.</summary>
        public byte[] RenderPng(
            tree_view? view = null, tree_style? style = null, CallOptions options = null)
        {
            using (var call = new NativeCall(options))
            {
                tree_view givenView = view.GetValueOrDefault();
                tree_style givenStyle = style.GetValueOrDefault();
                tree_picture* picture;
                call.Check(TreeNative.tree_render(
                    (tree_mesh*)call.Use(this), view.HasValue ? &givenView : null,
                    style.HasValue ? &givenStyle : null, call.Control, &picture));
                try
                {
                    tree_bytes* made;
                    call.Check(TreeNative.tree_picture_to_png(picture, &made));
                    return call.Take(made);
                }
                finally
                {
                    TreeNative.tree_picture_free(picture);
                }
            }
        }

        static UIntPtr Size(int number)
        {
            return (UIntPtr)checked((uint)number);
        }

        protected override bool ReleaseHandle()
        {
            return TreeNative.tree_mesh_free((tree_mesh*)handle) == TreeNative.TREE_OK;
        }
    }

    internal sealed unsafe class TextureHandle : TreeHandle
    {
        public TextureHandle(tree_texture* made)
        {
            Own(made);
        }

        protected override bool ReleaseHandle()
        {
            return TreeNative.tree_texture_free((tree_texture*)handle) == TreeNative.TREE_OK;
        }
    }
}
