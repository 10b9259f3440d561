//! Programs in C and in C# that print size and offsets of every struct: the two must say the same.

use super::c_header::Header;
use std::fmt::Write;

/// What C says of `include/tree.h`.
pub fn c_program(header: &Header) -> String {
    let mut text = String::from(
        "#include <stdio.h>\n#include <stddef.h>\n#include \"tree.h\"\n\nint main(void) {\n",
    );
    for record in &header.structs {
        let name = &record.name;
        let _ = writeln!(text, "    printf(\"{name} %zu\\n\", sizeof({name}));");
        for field in &record.fields {
            let field = &field.name;
            let print = format!("printf(\"{name}.{field} %zu\\n\", offsetof({name}, {field}));");
            let _ = writeln!(text, "    {print}");
        }
    }
    text.push_str("    return 0;\n}\n");
    text
}

/// What C# says of `TreeNative.cs`.
pub fn csharp_program(header: &Header) -> String {
    let mut text = String::from(
        "using System;\nusing TreeFamily.Native;\n\npublic static unsafe class Layout\n{\n",
    );
    let print = |what: &str| format!("        Console.WriteLine(\"{{0}} {{1}}\", {what});\n");
    for record in &header.structs {
        let name = &record.name;
        let _ = write!(text, "    static void Of_{name}()\n    {{\n        {name} x;\n");
        text += &print(&format!("\"{name}\", sizeof({name})"));
        for field in &record.fields {
            let place = super::csharp::address(field);
            text += &print(&format!("\"{name}.{}\", (byte*){place} - (byte*)&x", field.name));
        }
        text.push_str("    }\n\n");
    }
    text.push_str("    public static void Main()\n    {\n");
    for record in &header.structs {
        let _ = writeln!(text, "        Of_{}();", record.name);
    }
    text.push_str("    }\n}\n");
    text
}
