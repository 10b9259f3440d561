//! Clouds of points from files, as laser scanners and their programs write them.
//!
//! * PLY: text, or binary of either order of bytes; numbers of any sort, other properties (colours,
//!   normals, intensities, lists) and elements passed over.
//! * XYZ, TXT, CSV, ASC, PTS: a point on each line, columns parted by blanks, commas, semicolons or
//!   tabs. A line of names may say which columns are x, y and z; else they are the first three. Lines
//!   behind `#`, `//` and `;` are comments.
//!
//! Coordinates are f64: those of surveys have seven digits before the point. Numbers that are not
//! finite are handed on; who uses the points says what becomes of them.

use super::import::read_bytes;
use super::ply;
use crate::error::{MeshError, Result};
use glam::DVec3;
use std::path::Path;
use tree_core::{Control, Resource};

/// Lines between two looks at whether the caller has cancelled.
const LINES_PER_CHECK: usize = 1 << 14;
/// Longest line of text.
const LINE_MAX: usize = 1 << 16;
/// Lines without numbers that may come before the first point.
const HEADER_MAX: usize = 64;

/// Points and what was passed over.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Points {
    /// The points in their own axes and unit.
    pub positions: Vec<DVec3>,
    /// Lines of text that are no points: names, counts and comments.
    pub n_other_lines: usize,
}

/// Reads a cloud from a file with the extension `ply`, `xyz`, `txt`, `csv`, `asc` or `pts`, in
/// letters of any case.
///
/// # Errors
/// [`MeshError::Unsupported`] for other extensions; [`MeshError::Malformed`] with the line or row;
/// [`MeshError::Limit`] for more points than [`Limits::graph_nodes`](tree_core::Limits::graph_nodes),
/// or too large a file; [`MeshError::Core`] when it cannot be read; [`MeshError::Cancelled`].
///
/// # Complexity
/// O(bytes).
pub fn read(path: impl AsRef<Path>, control: &Control) -> Result<Points> {
    let path = path.as_ref();
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    match extension.as_str() {
        "ply" => from_ply(&read_bytes(path, control)?, control),
        "xyz" | "txt" | "csv" | "asc" | "pts" => from_text(&read_bytes(path, control)?, control),
        _ => Err(MeshError::Unsupported {
            format: "cloud",
            what: format!("the extension '{extension}' of {}", path.display()),
        }),
    }
}

/// Reads the vertices of a PLY file in memory.
///
/// # Errors
/// As [`read`], files apart.
pub fn from_ply(bytes: &[u8], control: &Control) -> Result<Points> {
    control.limits.check(Resource::InputBytes, bytes.len() as u64)?;
    Ok(Points { positions: ply::points(bytes, control)?, n_other_lines: 0 })
}

/// Reads points from text in memory.
///
/// # Errors
/// As [`read`], files apart.
pub fn from_text(bytes: &[u8], control: &Control) -> Result<Points> {
    control.limits.check(Resource::InputBytes, bytes.len() as u64)?;
    let mut points = Points::default();
    let mut columns = [0, 1, 2];
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    for (number, line) in bytes.split(|&byte| byte == b'\n' || byte == b'\r').enumerate() {
        if number % LINES_PER_CHECK == 0 {
            control.check()?;
        }
        let fail = |problem: &str| malformed(format!("line {}", number + 1), problem);
        if line.len() > LINE_MAX {
            return Err(fail("longer than 65536 bytes"));
        }
        let line = line.trim_ascii();
        let is_comment = [&b"#"[..], b"//", b";"].iter().any(|start| line.starts_with(start));
        if line.is_empty() {
            continue;
        }
        if !is_comment && let Some(point) = point(line, columns) {
            let n = points.positions.len() as u64 + 1;
            control.limits.check(Resource::GraphNodes, n)?;
            points.positions.push(point);
            continue;
        }
        let is_header = points.positions.is_empty() && points.n_other_lines < HEADER_MAX;
        if is_header {
            // Names may stand in a comment.
            columns = names(line).unwrap_or(columns);
        } else if !is_comment {
            return Err(fail("three numbers are needed"));
        }
        points.n_other_lines += 1;
    }
    if points.positions.is_empty() {
        return Err(malformed("file".into(), "no line with three numbers"));
    }
    Ok(points)
}

/// The words of a line.
fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    // Two commas have an empty word between them, two blanks have not.
    let comma = [b',', b';'].into_iter().find(|separator| line.contains(separator));
    line.split(move |&byte| match comma {
        Some(comma) => byte == comma,
        None => byte.is_ascii_whitespace(),
    })
    .map(<[u8]>::trim_ascii)
    .filter(move |word| comma.is_some() || !word.is_empty())
}

/// The numbers in three columns of a line.
fn point(line: &[u8], columns: [usize; 3]) -> Option<DVec3> {
    let mut point = [None; 3];
    for (at, word) in words(line).enumerate() {
        for (value, _) in point.iter_mut().zip(columns).filter(|(_, column)| *column == at) {
            *value = Some(std::str::from_utf8(word).ok()?.parse().ok()?);
        }
    }
    let [x, y, z] = point;
    Some(DVec3::new(x?, y?, z?))
}

/// Which columns are named x, y and z.
fn names(line: &[u8]) -> Option<[usize; 3]> {
    let line = line.trim_ascii_start();
    let start = line.iter().position(|byte| !b"#/;".contains(byte))?;
    let line = line.get(start..)?.trim_ascii();
    let is = |word: &[u8], name: &str| {
        let word = word.strip_prefix(b"\"").and_then(|w| w.strip_suffix(b"\"")).unwrap_or(word);
        word.strip_prefix(b"//").unwrap_or(word).eq_ignore_ascii_case(name.as_bytes())
    };
    let column = |name: &str| words(line).position(|word| is(word, name));
    Some([column("x")?, column("y")?, column("z")?])
}

fn malformed(place: String, problem: &str) -> MeshError {
    MeshError::Malformed { format: "point cloud", place, problem: problem.into() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::samples::{Dice, damaged};
    use tree_core::Limits;

    fn text(text: &str) -> Result<Points> {
        from_text(text.as_bytes(), &Control::default())
    }

    #[test]
    fn text_of_all_sorts_is_read() {
        let expected = [DVec3::new(512_345.125, -2.0, 3e-1), DVec3::new(4.0, 5.0, 6.0)];
        for (file, n_other_lines) in [
            ("512345.125 -2 0.3\n4 5 6\n", 0),
            ("2\r\n512345.125\t-2\t0.3\t17 255 0 0\r\n\r\n4\t5\t6\t1 2 3 4", 1),
            ("\u{feff}x,y,z,i\n512345.125,-2,.3,\n4,5,6,\n# end\n", 2),
            ("# a scan\n//X Y Z R\n512345.125 -2 3e-1 a\n 4  5   6 b\n", 2),
            ("\"t\";\"z\";\"x\";\"y\"\n0;0.3;512345.125;-2\n1;6;4;5\n", 1),
        ] {
            let found = text(file).unwrap();
            assert_eq!(found.positions, expected, "{file}");
            assert_eq!(found.n_other_lines, n_other_lines, "{file}");
        }
        assert!(text("1 nan 3").unwrap().positions[0].y.is_nan());
    }

    #[test]
    fn broken_text_is_refused_with_its_line() {
        for (file, place) in [
            ("1 2 3\n4 5\n", "line 2"),
            ("1 2 3\n4 5 x\n", "line 2"),
            ("x y\n", "file"),
            ("", "file"),
        ] {
            let error = text(file).unwrap_err();
            assert!(
                matches!(&error, MeshError::Malformed { place: p, .. } if p == place),
                "{error}"
            );
        }
        let limits = Limits { graph_nodes: 1, ..Limits::default() };
        let control = Control::default().with_limits(limits);
        assert!(matches!(from_text(b"1 2 3\n4 5 6", &control), Err(MeshError::Limit(_))));
    }

    fn ply(format: &str) -> Vec<u8> {
        let mut file = format!(
            "ply\nformat {format} 1.0\nelement sensor 1\nproperty list uchar float pose\n\
             element vertex 2\nproperty uchar red\nproperty double y\nproperty float x\n\
             property list uchar short echoes\nproperty int z\nproperty float intensity\nend_header\n"
        )
        .into_bytes();
        let rows = [(7_u8, -2.5_f64, 1.5_f32, 3_i16, 4_i32), (8, 5e6, 6.0, 7, -8)];
        if format == "ascii" {
            file.extend_from_slice(b"2 0.5 0.25\n");
            for (red, y, x, echo, z) in rows {
                file.extend_from_slice(format!("{red} {y} {x} 1 {echo} {z} 0.5\n").as_bytes());
            }
            return file;
        }
        let big = format.contains("big");
        let mut put = |bytes: &[u8]| {
            let mut bytes = bytes.to_vec();
            if big {
                bytes.reverse();
            }
            file.extend(bytes);
        };
        put(&[1]);
        put(&0.5_f32.to_le_bytes());
        for (red, y, x, echo, z) in rows {
            put(&[red]);
            put(&y.to_le_bytes());
            put(&x.to_le_bytes());
            put(&[1]);
            put(&echo.to_le_bytes());
            put(&z.to_le_bytes());
            put(&0.5_f32.to_le_bytes());
        }
        file
    }

    #[test]
    fn ply_of_all_formats_is_read_without_faces() {
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            let found = from_ply(&ply(format), &Control::default()).unwrap();
            let expected = [DVec3::new(1.5, -2.5, 4.0), DVec3::new(6.0, 5e6, -8.0)];
            assert_eq!(found.positions, expected, "{format}");
        }
    }

    #[test]
    fn damaged_clouds_never_panic() {
        let (control, mut dice) = (Control::default(), Dice(5));
        let mut n_read = 0;
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            for _ in 0..500 {
                n_read += u32::from(from_ply(&damaged(&ply(format), &mut dice), &control).is_ok());
            }
        }
        for _ in 0..500 {
            let file = damaged(b"x,y,z\n1,2,3\n4.5,-6,7e2\n# end\n", &mut dice);
            n_read += u32::from(from_text(&file, &control).is_ok());
        }
        assert!(n_read > 100, "{n_read}");
    }
}
