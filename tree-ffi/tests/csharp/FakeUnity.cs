// As much of Unity's interface as UnityTree.cs uses, so that it is compiled and run without Unity.
using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public class Object
    {
        public string name { get; set; }
    }

    public class MonoBehaviour : Object
    {
        readonly Dictionary<Type, object> parts = new Dictionary<Type, object>();

        public T GetComponent<T>() where T : new()
        {
            object part;
            if (!parts.TryGetValue(typeof(T), out part))
            {
                parts[typeof(T)] = part = new T();
            }
            return (T)part;
        }
    }

    public class MeshFilter { public Mesh sharedMesh { get; set; } }

    public class MeshRenderer { public Material[] sharedMaterials { get; set; } }

    public enum MeshTopology { Triangles = 0 }

    public class Mesh : Object
    {
        public Rendering.IndexFormat indexFormat { get; set; }
        public Vector3[] vertices { get; set; }
        public Vector3[] normals { get; set; }
        public Vector2[] uv { get; set; }
        public Vector4[] tangents { get; set; }
        public int subMeshCount { get; set; }
        public readonly Dictionary<int, int[]> Indices = new Dictionary<int, int[]>();
        public bool HasBounds;

        public void SetIndices(int[] indices, MeshTopology topology, int submesh)
        {
            Indices[submesh] = indices;
        }

        public void RecalculateBounds()
        {
            HasBounds = true;
        }
    }

    public struct Vector2
    {
        public float x, y;
        public Vector2(float x, float y) { this.x = x; this.y = y; }
    }

    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
    }

    public struct Vector4
    {
        public float x, y, z, w;
        public Vector4(float x, float y, float z, float w)
        {
            this.x = x; this.y = y; this.z = z; this.w = w;
        }
    }

    public struct Color
    {
        public float r, g, b, a;
        public Color(float r, float g, float b, float a)
        {
            this.r = r; this.g = g; this.b = b; this.a = a;
        }
        public Color gamma { get { return this; } }
    }

    public struct Color32
    {
        public byte r, g, b, a;
        public Color32(byte r, byte g, byte b, byte a)
        {
            this.r = r; this.g = g; this.b = b; this.a = a;
        }
    }

    public enum TextureFormat { RGBA32 = 4 }

    public enum TextureWrapMode { Repeat = 0 }

    public class Texture : Object { }

    public class Texture2D : Texture
    {
        public readonly int width, height;
        public Color32[] Pixels;
        public TextureWrapMode wrapMode { get; set; }

        public Texture2D(int width, int height, TextureFormat format, bool mipChain, bool linear)
        {
            this.width = width;
            this.height = height;
        }

        public void SetPixels32(Color32[] pixels) { Pixels = pixels; }
        public void Apply(bool updateMipmaps, bool makeNoLongerReadable) { }
    }

    public class Shader : Object
    {
        public static Shader Find(string name) { return new Shader { name = name }; }
    }

    public class Material : Object
    {
        public readonly Dictionary<string, object> Set = new Dictionary<string, object>();
        public int renderQueue { get; set; }

        public Material(Shader shader) { }
        public bool HasProperty(string name) { return name[1] != 'B' && name != "_AlphaClip"; }
        public void SetColor(string name, Color value) { Set[name] = value; }
        public void SetTexture(string name, Texture value) { Set[name] = value; }
        public void SetFloat(string name, float value) { Set[name] = value; }
        public void EnableKeyword(string name) { Set[name] = true; }
    }

    public class RequireComponent : Attribute
    {
        public RequireComponent(Type one, Type two) { }
    }

    public class TooltipAttribute : Attribute
    {
        public TooltipAttribute(string text) { }
    }

    public class RangeAttribute : Attribute
    {
        public RangeAttribute(float low, float high) { }
    }

    public class ContextMenu : Attribute
    {
        public ContextMenu(string name) { }
    }
}

namespace UnityEngine.Rendering
{
    public enum IndexFormat { UInt16, UInt32 }

    public enum CullMode { Off = 0 }

    public enum RenderQueue { AlphaTest = 2450 }

    public static class GraphicsSettings
    {
        public static object defaultRenderPipeline { get { return null; } }
    }
}
