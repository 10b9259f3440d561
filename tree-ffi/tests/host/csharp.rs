//! From the header to `examples/csharp/TreeNative.cs`: C# 7, which Unity and Mono both take.

use super::c_header::{Callback, Field, Header, Type};
use std::fmt::Write;

const TOP: &str = "\
// The tree family's C interface for C#: made from include/tree.h, do not edit.
//   TREE_UPDATE=1 cargo test -p tree-ffi --test csharp
// Licence: MIT OR Apache-2.0.
//
// As in C: nothing here is checked, counted or freed for you. Tree.cs does that.
// size_t is UIntPtr, char a byte of UTF-8, a function pointer an IntPtr: what
// Marshal.GetFunctionPointerForDelegate makes of a delegate, which must be kept alive for as long as the
// library may call it.

using System;
using System.Runtime.InteropServices;

#pragma warning disable 0649, 1591

namespace TreeFamily.Native
{
";

/// The C# of a header.
pub fn write(header: &Header) -> Result<String, String> {
    let writer = Writer { header };
    let mut text = TOP.to_owned();
    for opaque in &header.opaques {
        document(&mut text, 1, &opaque.doc);
        line(&mut text, 1, &format!("public struct {} {{ }}\n", opaque.name));
    }
    for callback in &header.callbacks {
        writer.callback(&mut text, callback)?;
    }
    for record in &header.structs {
        document(&mut text, 1, &record.doc);
        line(&mut text, 1, "[StructLayout(LayoutKind.Sequential)]");
        line(&mut text, 1, &format!("public unsafe struct {}", record.name));
        line(&mut text, 1, "{");
        for field in &record.fields {
            writer.field(&mut text, field)?;
        }
        line(&mut text, 1, "}\n");
    }
    line(&mut text, 1, "/// <summary>The header's constants and functions.</summary>");
    line(&mut text, 1, "public static unsafe class TreeNative");
    line(&mut text, 1, "{");
    text.push_str(LIBRARY);
    for constant in &header.constants {
        document(&mut text, 2, &constant.doc);
        let (kind, value) = constant_of(&constant.value)?;
        line(&mut text, 2, &format!("public {kind} {} = {value};\n", constant.name));
    }
    for function in &header.functions {
        document(&mut text, 2, &function.doc);
        line(&mut text, 2, "[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]");
        let result = writer.kind(&function.result)?;
        let arguments = writer.arguments(&function.arguments)?;
        let declared = format!("public static extern {result} {}({arguments});\n", function.name);
        line(&mut text, 2, &declared);
    }
    text.truncate(text.trim_end().len());
    text.push_str("\n    }\n}\n");
    Ok(text)
}

const LIBRARY: &str = "\
#if (UNITY_IOS || UNITY_WEBGL) && !UNITY_EDITOR
        /// <summary>The library is linked into the program there.</summary>
        public const string Library = \"__Internal\";
#else
        /// <summary>libtree_ffi.so, libtree_ffi.dylib or tree_ffi.dll.</summary>
        public const string Library = \"tree_ffi\";
#endif

";

struct Writer<'a> {
    header: &'a Header,
}

impl Writer<'_> {
    fn callback(&self, text: &mut String, callback: &Callback) -> Result<(), String> {
        document(text, 1, &callback.doc);
        line(text, 1, "[UnmanagedFunctionPointer(CallingConvention.Cdecl)]");
        let result = self.kind(&callback.result)?;
        let arguments = self.arguments(&callback.arguments)?;
        line(
            text,
            1,
            &format!("public unsafe delegate {result} {}({arguments});\n", callback.name),
        );
        Ok(())
    }

    fn arguments(&self, arguments: &[Field]) -> Result<String, String> {
        let arguments: Result<Vec<_>, String> = arguments
            .iter()
            .map(|argument| {
                Ok(format!("{} {}", self.kind(&argument.kind)?, escaped(&argument.name)))
            })
            .collect();
        Ok(arguments?.join(", "))
    }

    fn field(&self, text: &mut String, field: &Field) -> Result<(), String> {
        document(text, 2, &field.doc);
        let name = escaped(&field.name);
        let Type::Array(..) = field.kind else {
            // What constants it takes, which C# would not say.
            let of = match &field.kind {
                Type::Name(alias)
                    if self.header.aliases.iter().any(|known| known.name == *alias) =>
                {
                    format!(" // {alias}")
                }
                _ => String::new(),
            };
            line(text, 2, &format!("public {} {name};{of}", self.kind(&field.kind)?));
            return Ok(());
        };
        let (element, length) = flat(&field.kind);
        let kind = self.kind(element)?;
        if is_fixed(&field.kind) {
            line(text, 2, &format!("public fixed {kind} {name}[{length}];"));
            return Ok(());
        }
        let names: Vec<_> = (0..length).map(|number| format!("{}_{number}", field.name)).collect();
        line(text, 2, &format!("public {kind} {};", names.join(", ")));
        Ok(())
    }

    fn kind(&self, kind: &Type) -> Result<String, String> {
        match kind {
            Type::Pointer(target) => Ok(format!("{}*", self.kind(target)?)),
            Type::Array(element, _) => Ok(format!("{}*", self.kind(flat(element).0)?)),
            Type::Function(_) => Ok("IntPtr".into()),
            Type::Name(name) => self.named(name),
        }
    }

    fn named(&self, name: &str) -> Result<String, String> {
        if let Some((_, csharp)) = PRIMITIVES.iter().find(|(c, _)| *c == name) {
            return Ok((*csharp).into());
        }
        if let Some(alias) = self.header.aliases.iter().find(|alias| alias.name == name) {
            return self.kind(&alias.target);
        }
        let mut known = (self.header.structs.iter().map(|record| &record.name))
            .chain(self.header.opaques.iter().map(|opaque| &opaque.name));
        if known.any(|known| known == name) {
            return Ok(name.into());
        }
        Err(format!("'{name}' is no type that C# is told of"))
    }
}

const PRIMITIVES: &[(&str, &str)] = &[
    ("void", "void"),
    ("char", "byte"),
    ("float", "float"),
    ("double", "double"),
    ("int8_t", "sbyte"),
    ("uint8_t", "byte"),
    ("int16_t", "short"),
    ("uint16_t", "ushort"),
    ("int32_t", "int"),
    ("uint32_t", "uint"),
    ("int64_t", "long"),
    ("uint64_t", "ulong"),
    ("size_t", "UIntPtr"),
];

/// The element of arrays of arrays, and how many there are.
fn flat(kind: &Type) -> (&Type, usize) {
    match kind {
        Type::Array(element, length) => {
            let (element, inner) = flat(element);
            (element, length * inner)
        }
        other => (other, 1),
    }
}

/// Where a field of `x` lies.
pub fn address(field: &Field) -> String {
    match &field.kind {
        Type::Array(..) if is_fixed(&field.kind) => format!("x.{}", escaped(&field.name)),
        Type::Array(..) => format!("&x.{}_0", field.name),
        _ => format!("&x.{}", escaped(&field.name)),
    }
}

/// Whether an array's elements are numbers: only they can be a fixed buffer.
fn is_fixed(kind: &Type) -> bool {
    match flat(kind).0 {
        Type::Name(name) => PRIMITIVES.iter().any(|(c, csharp)| c == name && *csharp != "UIntPtr"),
        _ => false,
    }
}

/// An `int` where it fits: C# takes an int constant for a uint too, but not the other way round.
fn constant_of(value: &str) -> Result<(&'static str, String), String> {
    if value == "SIZE_MAX" {
        return Ok((
            "static readonly UIntPtr",
            "(UIntPtr)(UIntPtr.Size == 8 ? ulong.MaxValue : uint.MaxValue)".into(),
        ));
    }
    let value = value.trim_end_matches('u');
    if value.parse::<i32>().is_ok() {
        return Ok(("const int", value.into()));
    }
    if value.parse::<u32>().is_ok() {
        return Ok(("const uint", value.into()));
    }
    if value.parse::<u64>().is_ok() {
        return Ok(("const ulong", value.into()));
    }
    let value = value.trim_end_matches('f');
    if value.parse::<f32>().is_ok() {
        return Ok(("const float", format!("{value}f")));
    }
    Err(format!("'{value}' is no constant that C# is told of"))
}

fn escaped(name: &str) -> String {
    const TAKEN: &[&str] = &[
        "base",
        "bool",
        "byte",
        "case",
        "char",
        "checked",
        "class",
        "const",
        "decimal",
        "default",
        "delegate",
        "event",
        "explicit",
        "extern",
        "fixed",
        "float",
        "implicit",
        "in",
        "interface",
        "internal",
        "is",
        "lock",
        "namespace",
        "new",
        "null",
        "object",
        "operator",
        "out",
        "override",
        "params",
        "private",
        "protected",
        "public",
        "readonly",
        "ref",
        "sealed",
        "string",
        "this",
        "unchecked",
        "using",
        "virtual",
    ];
    if TAKEN.contains(&name) { format!("@{name}") } else { name.into() }
}

fn document(text: &mut String, depth: usize, doc: &[String]) {
    if doc.is_empty() {
        return;
    }
    line(text, depth, "/// <summary>");
    for said in doc {
        let said = said.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        line(text, depth, format!("/// {said}").trim_end());
    }
    line(text, depth, "/// </summary>");
}

fn line(text: &mut String, depth: usize, what: &str) {
    let _ = writeln!(text, "{}{what}", "    ".repeat(depth));
}
