//! Strokes from and to JSON.

use crate::error::{ModelError, Result};
use crate::sketch::{Drawing, Role, Stroke};
use glam::Vec2;
use serde_json::Value;

/// Longest text read: a parsed text takes about thirty times its bytes.
const MAX_BYTES: usize = 32 << 20;

/// Reads one stroke in one of the forms, or says what is wrong with it.
type ReadStroke = fn(&Value) -> Result<Stroke, String>;

/// Reads a drawing from JSON, in any of these forms, y downwards:
///
/// * `{"strokes": [{"points": [[x, y], …], "role": "branch", "closed": false, "filled": false, "name": ""}, …]}`,
///   where all but the points may be missing; the role is `trunk`, `branch`, `crown` or `null`;
/// * `[[[x, y], …], …]`, bare lines;
/// * `{"drawing": [[[x…], [y…]], …]}`, a drawing of Quick, Draw! (a third list, the times, is passed over).
///
/// # Errors
/// [`ModelError::Sketch`] where the text is no JSON or none of these, or over 32 MiB; [`ModelError::Stroke`]
/// naming the stroke and the point at fault.
///
/// # Complexity
/// O(bytes).
pub fn from_json(text: &str) -> Result<Drawing> {
    if text.len() > MAX_BYTES {
        return sketch(format!("the text has {} bytes, at most {MAX_BYTES} are read", text.len()));
    }
    let value = match serde_json::from_str::<Value>(text) {
        Ok(value) => value,
        Err(error) => return sketch(format!("no JSON: {error}")),
    };
    let wanted = || {
        sketch("a list of lines, or an object with a list 'strokes' or 'drawing' is wanted".into())
    };
    let (list, read): (_, ReadStroke) = match &value {
        Value::Array(list) => (list, bare),
        Value::Object(object) => match (object.get("strokes"), object.get("drawing")) {
            (Some(Value::Array(list)), _) => (list, full),
            (None, Some(Value::Array(list))) => (list, quick),
            _ => return wanted(),
        },
        _ => return wanted(),
    };
    let strokes = list.iter().enumerate().map(|(index, value)| {
        let name = || format!("strokes[{index}]");
        read(value).map_err(|problem| ModelError::Stroke { stroke: name(), problem })
    });
    Ok(Drawing { strokes: strokes.collect::<Result<_>>()? })
}

/// Reads a drawing from each line that is not blank, in any form of [`from_json`]: the files of Quick, Draw!.
///
/// # Errors
/// As [`from_json`], naming the line as well, from 1.
///
/// # Complexity
/// O(bytes).
pub fn from_ndjson(text: &str) -> Result<Vec<Drawing>> {
    let lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let drawings = lines.map(|(row, line)| {
        from_json(line).map_err(|error| match error {
            ModelError::Sketch { problem } => {
                ModelError::Sketch { problem: format!("line {}: {problem}", row + 1) }
            }
            ModelError::Stroke { stroke, problem } => {
                ModelError::Stroke { stroke: format!("line {}, {stroke}", row + 1), problem }
            }
            other => other,
        })
    });
    drawings.collect()
}

/// A drawing as JSON, in the first form of [`from_json`].
///
/// # Errors
/// [`ModelError::Stroke`] naming a point that is not finite: JSON has no such numbers.
///
/// # Complexity
/// O(points).
pub fn to_json(drawing: &Drawing) -> Result<String> {
    for (index, stroke) in drawing.strokes.iter().enumerate() {
        if let Some(at) = stroke.points.iter().position(|p| !p.is_finite()) {
            let stroke = drawing.name_of(index);
            return Err(ModelError::Stroke {
                stroke,
                problem: format!("points[{at}] is not finite"),
            });
        }
    }
    serde_json::to_string(drawing)
        .map_err(|error| ModelError::Sketch { problem: error.to_string() })
}

fn sketch<T>(problem: String) -> Result<T> {
    Err(ModelError::Sketch { problem })
}

/// A stroke in our own form.
fn full(value: &Value) -> Result<Stroke, String> {
    let object = value.as_object().ok_or("an object with 'points' is wanted")?;
    let flag = |name: &str| match object.get(name) {
        None => Ok(false),
        Some(Value::Bool(flag)) => Ok(*flag),
        Some(_) => Err(format!("'{name}' must be true or false")),
    };
    let role = match object.get("role") {
        None | Some(Value::Null) => None,
        Some(value) => Some(match value.as_str() {
            Some("trunk") => Role::Trunk,
            Some("branch") => Role::Branch,
            Some("crown") => Role::Crown,
            _ => return Err("'role' must be 'trunk', 'branch', 'crown' or null".into()),
        }),
    };
    let name = match object.get("name") {
        None => String::new(),
        Some(Value::String(name)) => name.clone(),
        Some(_) => return Err("'name' must be a text".into()),
    };
    let points = bare(object.get("points").unwrap_or(&Value::Null))?.points;
    Ok(Stroke { points, role, closed: flag("closed")?, filled: flag("filled")?, name })
}

/// A stroke that is a list of points.
fn bare(value: &Value) -> Result<Stroke, String> {
    let list = value.as_array().ok_or("a list of points [x, y] is wanted")?;
    let points = list.iter().enumerate().map(|(at, point)| {
        let pair = point.as_array().filter(|pair| pair.len() == 2);
        let pair = pair.and_then(|pair| Some(Vec2::new(number(&pair[0])?, number(&pair[1])?)));
        pair.ok_or_else(|| format!("points[{at}] must be two numbers [x, y] that fit in 32 bits"))
    });
    Ok(Stroke::new(points.collect::<Result<_, _>>()?))
}

/// A stroke of Quick, Draw!: a list of x, a list of y, and in the raw files one of times.
fn quick(value: &Value) -> Result<Stroke, String> {
    let lists = value.as_array().filter(|lists| matches!(lists.len(), 2 | 3));
    let lists =
        lists.ok_or("two lists [[x, …], [y, …]] are wanted, with a third for times at most")?;
    let (Value::Array(xs), Value::Array(ys)) = (&lists[0], &lists[1]) else {
        return Err("x and y must be lists of numbers".into());
    };
    if xs.len() != ys.len() {
        return Err(format!("{} x and {} y: must be as many", xs.len(), ys.len()));
    }
    let points = xs.iter().zip(ys).enumerate().map(|(at, (x, y))| {
        let point = number(x).zip(number(y)).map(Vec2::from);
        point.ok_or_else(|| format!("point {at} must be two numbers that fit in 32 bits"))
    });
    Ok(Stroke::new(points.collect::<Result<_, _>>()?))
}

/// A number that is finite in 32 bits.
fn number(value: &Value) -> Option<f32> {
    value.as_f64().map(|n| n as f32).filter(|n| n.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn all_forms_give_the_same_line() {
        let line = vec![Vec2::new(1.0, 2.0), Vec2::new(3.5, 4.0)];
        for text in [
            r#"{"strokes":[{"points":[[1,2],[3.5,4]]}]}"#,
            "[[[1,2],[3.5,4]]]",
            r#"{"word":"tree","drawing":[[[1,3.5],[2,4]]]}"#,
            r#"{"drawing":[[[1,3.5],[2,4],[0,17]]]}"#,
        ] {
            assert_eq!(from_json(text).unwrap().strokes, [Stroke::new(line.clone())], "{text}");
        }
    }

    #[test]
    fn what_is_written_is_read_again() {
        let stroke = Stroke {
            points: vec![Vec2::new(0.1, -3e7), Vec2::ZERO],
            role: Some(Role::Crown),
            closed: true,
            filled: true,
            name: "a \"b\"".into(),
        };
        let drawing = Drawing { strokes: vec![stroke, Stroke::default()] };
        assert_eq!(from_json(&to_json(&drawing).unwrap()).unwrap(), drawing);
    }

    #[test]
    fn numbers_that_json_has_not_are_errors_that_name_the_point() {
        let drawing = Drawing { strokes: vec![Stroke::new(vec![Vec2::ZERO, Vec2::NAN])] };
        let error = to_json(&drawing).unwrap_err().to_string();
        assert_eq!(error, "strokes[0]: points[1] is not finite");
    }

    #[test]
    fn errors_name_the_line_the_stroke_and_the_point() {
        for (text, wanted) in [
            ("{", "no JSON"),
            ("7", "a list of lines"),
            (r#"{"strokes":7}"#, "a list of lines"),
            (r#"[[[0,0]],[[0,0],[1,2,3]]]"#, "strokes[1]: points[1]"),
            (r#"[[[0,0],[1,1e300]]]"#, "strokes[0]: points[1]"),
            (r#"[[[0,1e999]]]"#, "no JSON"),
            (r#"{"strokes":[{}]}"#, "strokes[0]: a list of points"),
            (r#"{"strokes":[{"points":[],"role":"root"}]}"#, "strokes[0]: 'role'"),
            (r#"{"strokes":[{"points":[],"closed":1}]}"#, "strokes[0]: 'closed'"),
            (r#"{"drawing":[[[0,1],[2]]]}"#, "strokes[0]: 2 x and 1 y"),
            (r#"{"drawing":[[[0,null],[2,3]]]}"#, "strokes[0]: point 1"),
        ] {
            let error = from_json(text).unwrap_err().to_string();
            assert!(error.contains(wanted), "{text} gives {error}");
            let error = from_ndjson(&format!("[]\n\n{text}")).unwrap_err().to_string();
            assert!(error.contains("line 3") && error.contains(wanted), "{text} gives {error}");
        }
    }

    #[test]
    fn deep_nesting_is_an_error() {
        assert!(from_json(&"[".repeat(1_000_000)).is_err());
    }

    proptest! {
        #[test]
        fn no_text_panics(text in r#"[\[\]{}",:0-9e.a-z-]{0,60}"#) {
            let _ = from_json(&text);
            let _ = from_ndjson(&text);
        }
    }
}
