//! The vertices of a PLY file as a cloud of points.

use super::body::{Body, at};
use super::header::parse;
use super::malformed;
use crate::error::Result;
use glam::DVec3;
use tree_core::{Control, Resource};

/// Rows between two looks at whether the caller has cancelled.
const ROWS_PER_CHECK: u64 = 1 << 14;

/// Reads x, y and z of all vertices; other properties and elements are passed over.
pub(in crate::io) fn points(bytes: &[u8], control: &Control) -> Result<Vec<DVec3>> {
    let (header, rest) = parse(bytes)?;
    let mut body = Body::new(rest, header.format);
    for element in &header.elements {
        if element.name != "vertex" {
            body.skip(element)?;
            continue;
        }
        let role = |name: &str| ["x", "y", "z"].iter().position(|axis| *axis == name);
        let roles: Vec<Option<usize>> = element
            .properties
            .iter()
            .map(|property| role(&property.name).filter(|_| property.count.is_none()))
            .collect();
        if !(0..3).all(|axis| roles.contains(&Some(axis))) {
            return Err(malformed("element vertex", "x, y and z are needed"));
        }
        body.check(element)?;
        control.limits.check(Resource::GraphNodes, element.n_rows)?;
        let mut points = Vec::with_capacity(element.n_rows as usize);
        for row in 0..element.n_rows {
            if row % ROWS_PER_CHECK == 0 {
                control.check()?;
            }
            let mut point = DVec3::ZERO;
            for (property, role) in element.properties.iter().zip(&roles) {
                let read = match role {
                    Some(axis) => body.number(property.kind).map(|value| point[*axis] = value),
                    None => body.skip_property(property),
                };
                read.ok_or_else(|| at(element, row))?;
            }
            points.push(point);
        }
        return Ok(points);
    }
    Err(malformed("header", "no element of vertices"))
}
