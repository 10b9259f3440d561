// As much of Unity's interface as UnityTree.cs uses, so that it is compiled and run without Unity.
using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public enum HideFlags { None = 0, DontSave = 52 }

    public class Object
    {
        /// <summary>What Unity holds in memory until it is destroyed; shaders and components left out.</summary>
        public static readonly HashSet<Object> Alive = new HashSet<Object>();

        public string name { get; set; }
        public HideFlags hideFlags { get; set; }

        public static void Destroy(Object gone)
        {
            End(gone, true);
        }

        public static void DestroyImmediate(Object gone)
        {
            End(gone, false);
        }

        static void End(Object gone, bool playing)
        {
            if (Application.isPlaying != playing || !Alive.Remove(gone))
            {
                throw new InvalidOperationException("destroyed twice, or not as this mode wants it");
            }
        }
    }

    public static class Application { public static bool isPlaying = true; }

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

    public class MeshFilter : Object { public Mesh sharedMesh { get; set; } }

    public class MeshRenderer : Object { public Material[] sharedMaterials { get; set; } }

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

        public Mesh() { Alive.Add(this); }

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
            Alive.Add(this);
        }

        public void SetPixels32(Color32[] pixels) { Pixels = pixels; }
        public void Apply(bool updateMipmaps, bool makeNoLongerReadable) { }
    }

    public class Shader : Object
    {
        static readonly Dictionary<string, string> Known = new Dictionary<string, string>
        {
            { "Standard", "_Color _MainTex _Glossiness _Cutoff _Mode" },
            {
                "Universal Render Pipeline/Lit",
                "_BaseColor _BaseMap _Smoothness _Cutoff _AlphaClip _Cull"
            },
            {
                "HDRP/Lit",
                "_BaseColor _BaseColorMap _Smoothness _AlphaCutoff _AlphaCutoffEnable _CullMode "
                + "_CullModeForward _DoubleSidedEnable"
            }
        };

        public static Shader Find(string name)
        {
            return Known.ContainsKey(name) ? new Shader { name = name } : null;
        }

        public int FindPropertyIndex(string property)
        {
            return Array.IndexOf(Known[name].Split(' '), property);
        }
    }

    public class Material : Object
    {
        public readonly Dictionary<string, object> Set = new Dictionary<string, object>();
        public int renderQueue { get; set; }
        public Shader shader { get; private set; }

        public Material(Shader shader)
        {
            this.shader = shader;
            Alive.Add(this);
        }

        public bool HasProperty(string name) { return shader.FindPropertyIndex(name) >= 0; }
        public void SetColor(string name, Color value) { Set[name] = value; }
        public void SetVector(string name, Vector4 value) { Set[name] = value; }
        public void SetTexture(string name, Texture value) { Set[name] = value; }
        public void SetFloat(string name, float value) { Set[name] = value; }
        public void EnableKeyword(string name) { Set[name] = true; }
        public void SetOverrideTag(string name, string value) { Set[name] = value; }
    }

    public class ExecuteAlways : Attribute { }

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

    public class RenderPipelineAsset : Object { }

    public class UniversalRenderPipelineAsset : RenderPipelineAsset { }

    public class HDRenderPipelineAsset : RenderPipelineAsset { }

    public static class GraphicsSettings
    {
        public static RenderPipelineAsset currentRenderPipeline { get; set; }
    }
}
