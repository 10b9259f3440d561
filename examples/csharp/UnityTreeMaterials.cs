// From the library's materials and pictures to Unity's. Compiled by Unity only.
#if UNITY_5_3_OR_NEWER
using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using TreeFamily;

/// <summary>Materials for Standard, and for Lit of the Universal and the High Definition pipeline.</summary>
public static class UnityTreeMaterials
{
    // What a property is called, by shader: HDRP/Lit, Universal Render Pipeline/Lit, Standard. Set where
    // the material has it, so that shaders of your own with these names work too.
    static readonly string[] ColorNames = { "_BaseColor", "_Color" };
    static readonly string[] PictureNames = { "_BaseColorMap", "_BaseMap", "_MainTex" };
    static readonly string[] SmoothnessNames = { "_Smoothness", "_Glossiness" };
    static readonly string[] CutoffNames = { "_AlphaCutoff", "_Cutoff" };
    static readonly string[] CutNames = { "_AlphaCutoffEnable", "_AlphaClip", "_Mode" };
    static readonly string[] CullNames = { "_CullMode", "_CullModeForward", "_Cull" };

    /// <summary>
    /// A material for each surface that has triangles. Materials and their textures are added to `made`,
    /// for the caller to destroy.
    /// </summary>
    public static Material[] Make(
        TreeMesh tree, Shader shader, ICollection<UnityEngine.Object> made)
    {
        TreeSurface[] surfaces = UnityTreeMesh.Surfaces(tree);
        var materials = new Material[surfaces.Length];
        for (int number = 0; number < surfaces.Length; number++)
        {
            TreeMaterial from = tree.Material(surfaces[number].Material);
            var to = new Material(shader) { name = from.Name };
            made.Add(to);
            if (from.Pixels != null)
            {
                Texture2D picture = Picture(from);
                made.Add(picture);
                Each(to, PictureNames, name => to.SetTexture(name, picture));
            }
            Fill(to, from);
            materials[number] = to;
        }
        return materials;
    }

    /// <summary>The Lit shader of the pipeline in use, or Standard.</summary>
    public static Shader DefaultShader()
    {
        string name = "Standard";
        RenderPipelineAsset pipeline = GraphicsSettings.currentRenderPipeline;
        if (pipeline != null)
        {
            // By name: the pipelines' own classes are not there in every project.
            name = pipeline.GetType().Name.Contains("HDRenderPipeline")
                ? "HDRP/Lit"
                : "Universal Render Pipeline/Lit";
        }
        Shader shader = Shader.Find(name);
        if (shader == null)
        {
            throw new InvalidOperationException(
                "The shader " + name + " is not in the build: set `shader` of the tree, or add it to "
                + "Always Included Shaders in the project's graphics settings.");
        }
        return shader;
    }

    /// <summary>Whether materials of the shader can be told to draw both sides; Standard cannot.</summary>
    public static bool DrawsBackFaces(Shader shader)
    {
        return Array.Exists(CullNames, name => shader.FindPropertyIndex(name) >= 0);
    }

    /// <summary>Unity's rows run from bottom to top.</summary>
    public static Texture2D Picture(TreeMaterial material)
    {
        int row = material.Width;
        var colors = new Color32[row * material.Height];
        for (int i = 0; i < colors.Length; i++)
        {
            int from = 4 * ((material.Height - 1 - i / row) * row + i % row);
            colors[i] = new Color32(
                material.Pixels[from], material.Pixels[from + 1], material.Pixels[from + 2],
                material.Pixels[from + 3]);
        }
        var texture = new Texture2D(
            material.Width, material.Height, TextureFormat.RGBA32, true, false)
        {
            name = material.Name,
            wrapMode = TextureWrapMode.Repeat
        };
        // Only the first level: Apply makes the smaller ones.
        texture.SetPixels32(colors);
        texture.Apply(true, false);
        return texture;
    }

    static void Fill(Material to, TreeMaterial from)
    {
        // Unity takes material colours for sRGB.
        Color color = new Color(
            from.BaseColor[0], from.BaseColor[1], from.BaseColor[2], from.BaseColor[3]).gamma;
        Each(to, ColorNames, name => to.SetColor(name, color));
        Each(to, SmoothnessNames, name => to.SetFloat(name, 1f - from.Roughness));
        if (from.AlphaCutoff > 0f)
        {
            Each(to, CutoffNames, name => to.SetFloat(name, from.AlphaCutoff));
            Each(to, CutNames, name => to.SetFloat(name, 1f));
            to.EnableKeyword("_ALPHATEST_ON");
            to.SetOverrideTag("RenderType", "TransparentCutout");
            to.renderQueue = (int)RenderQueue.AlphaTest;
        }
        if (from.DoubleSided)
        {
            Each(to, CullNames, name => to.SetFloat(name, (float)CullMode.Off));
            if (to.HasProperty("_DoubleSidedEnable"))
            {
                // What HDRP's inspector does for "Double-Sided, Flip".
                to.SetFloat("_DoubleSidedEnable", 1f);
                to.SetVector("_DoubleSidedConstants", new Vector4(-1f, -1f, -1f, 0f));
                to.EnableKeyword("_DOUBLESIDED_ON");
            }
        }
    }

    static void Each(Material material, string[] names, Action<string> set)
    {
        foreach (string name in names)
        {
            if (material.HasProperty(name))
            {
                set(name);
            }
        }
    }
}
#endif
