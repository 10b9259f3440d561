// What C# gets of a mesh: copies, that outlive the library's objects.
using System;
using System.Runtime.InteropServices;
using TreeFamily.Native;

namespace TreeFamily
{
    /// <summary>
    /// Columns of a surface by the library's axes: right-handed, +Y up, metres, triangles counter-clockwise,
    /// v downwards. Those that are absent are empty.
    /// </summary>
    public sealed unsafe class TreeSurface
    {
        /// <summary>Three for each vertex.</summary>
        public readonly float[] Positions;
        /// <summary>Three for each vertex.</summary>
        public readonly float[] Normals;
        /// <summary>Two for each vertex.</summary>
        public readonly float[] Uvs;
        /// <summary>Four for each vertex, or none.</summary>
        public readonly float[] Tangents;
        /// <summary>Two for each vertex, for light maps, or none.</summary>
        public readonly float[] Uvs2;
        /// <summary>Three for each triangle.</summary>
        public readonly int[] Indices;
        /// <summary>The material.</summary>
        public readonly int Material;

        internal TreeSurface(tree_surface view)
        {
            int vertices = checked((int)view.n_vertices);
            Positions = Floats(view.positions, 3 * vertices);
            Normals = Floats(view.normals, 3 * vertices);
            Uvs = Floats(view.uvs, 2 * vertices);
            Tangents = Floats(view.tangents, 4 * vertices);
            Uvs2 = Floats(view.uvs2, 2 * vertices);
            Indices = new int[checked((int)view.n_indices)];
            if (Indices.Length > 0)
            {
                Marshal.Copy((IntPtr)view.indices, Indices, 0, Indices.Length);
            }
            Material = (int)view.material;
        }

        /// <summary>
        /// Turns everything from the library's axes into an engine's, in place and once:
        /// TreeNative.TREE_CONVENTION_UNITY and so on.
        /// </summary>
        public void Convert(int convention)
        {
            uint to = checked((uint)convention);
            var vertices = (UIntPtr)VertexCount;
            using (var call = new NativeCall())
            fixed (float* positions = Positions, normals = Normals, uvs = Uvs, tangents = Tangents)
            fixed (int* indices = Indices)
            {
                const int way = TreeNative.TREE_CONVERT_TO;
                call.Check(TreeNative.tree_convert_positions(
                    to, way, positions, vertices, positions));
                call.Check(TreeNative.tree_convert_directions(
                    to, way, normals, vertices, normals));
                call.Check(TreeNative.tree_convert_uvs(to, uvs, vertices, uvs));
                call.Check(TreeNative.tree_convert_tangents(
                    to, way, tangents, (UIntPtr)(Tangents.Length / 4), tangents));
                call.Check(TreeNative.tree_convert_triangles(
                    to, (uint*)indices, (UIntPtr)(Indices.Length / 3), (uint*)indices));
            }
        }

        /// <summary>Number of vertices.</summary>
        public int VertexCount
        {
            get { return Positions.Length / 3; }
        }

        static float[] Floats(float* column, int length)
        {
            if (column == null)
            {
                return new float[0];
            }
            var copy = new float[length];
            if (length > 0)
            {
                Marshal.Copy((IntPtr)column, copy, 0, length);
            }
            return copy;
        }
    }

    /// <summary>What a surface looks like, in glTF's terms.</summary>
    public sealed unsafe class TreeMaterial
    {
        /// <summary>Name for people and files.</summary>
        public readonly string Name;
        /// <summary>Linear red, green, blue and alpha, multiplied with the picture.</summary>
        public readonly float[] BaseColor;
        /// <summary>0 mirror-like to 1 matt.</summary>
        public readonly float Roughness;
        /// <summary>Alpha below which pixels are not drawn; 0 when alpha is ignored.</summary>
        public readonly float AlphaCutoff;
        /// <summary>Whether back faces are drawn, with their normals turned over.</summary>
        public readonly bool DoubleSided;
        /// <summary>Share of the light on one face that shines through the other.</summary>
        public readonly float Translucency;
        /// <summary>Width of the picture; 0 when there is none.</summary>
        public int Width { get; private set; }
        /// <summary>Height of the picture.</summary>
        public int Height { get; private set; }
        /// <summary>Red, green, blue and alpha in sRGB, rows from top to bottom; or null.</summary>
        public byte[] Pixels { get; private set; }

        internal TreeMaterial(tree_material view)
        {
            Name = NativeText.Read(view.name);
            BaseColor = new[]
            {
                view.base_color[0], view.base_color[1], view.base_color[2], view.base_color[3],
            };
            Roughness = view.roughness;
            AlphaCutoff = view.alpha == TreeNative.TREE_ALPHA_MASK ? view.alpha_cutoff : 0f;
            DoubleSided = view.double_sided != 0;
            Translucency = view.translucency;
        }

        internal void CopyPixels(tree_texture_pixels pixels)
        {
            Width = checked((int)pixels.width);
            Height = checked((int)pixels.height);
            Pixels = new byte[checked(4 * Width * Height)];
            Marshal.Copy((IntPtr)pixels.pixels, Pixels, 0, Pixels.Length);
        }
    }
}
