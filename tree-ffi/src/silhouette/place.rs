//! How branches are arranged round their parent, where they may stand, and where they do.

use crate::border::{
    self, Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, out, out_value, tree_status,
    write,
};
use crate::io::tree_bytes;
use bytemuck::{Pod, Zeroable};
use std::ffi::c_char;
use tree_model::silhouette::place::{Arrangement, Domain, Site};

/// A pattern of branches round their parent: a `TREE_ARRANGEMENT_` constant.
pub type tree_arrangement_kind = u32;

/// Evenly over length and azimuth, without a pattern. The default.
pub const TREE_ARRANGEMENT_SPREAD: u32 = 0;
/// One at a node, each turned against the last by `angle`.
pub const TREE_ARRANGEMENT_SPIRAL: u32 = 1;
/// Two at a node, all pairs in one plane.
pub const TREE_ARRANGEMENT_OPPOSITE: u32 = 2;
/// Two at a node, each pair across the last.
pub const TREE_ARRANGEMENT_DECUSSATE: u32 = 3;
/// `per_node` at a node, each whorl turned against the last by `angle`.
pub const TREE_ARRANGEMENT_WHORLED: u32 = 4;
/// Two at a node, all in the horizontal plane, which lies at the azimuth `angle`.
pub const TREE_ARRANGEMENT_HORIZONTAL: u32 = 5;
/// Any other: `per_node` at a node, each node turned against the last by `angle`.
pub const TREE_ARRANGEMENT_CUSTOM: u32 = 6;

/// How branches are arranged round their parent: in the paper's terms n:φ. A part of other structs; zeros are
/// `TREE_ARRANGEMENT_SPREAD`. `tree_arrangement_from_text` fills one in by name.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct tree_arrangement {
    /// Which pattern.
    pub kind: tree_arrangement_kind,
    /// Branches at a node, 1 to 64; read for whorls and custom patterns.
    pub per_node: u32,
    /// In radians, -2π to 2π: the turn from a node to the next of spirals, whorls and custom patterns, the azimuth
    /// of horizontal pairs.
    pub angle: f32,
}

impl tree_arrangement {
    pub(crate) fn of(arrangement: &Arrangement) -> Self {
        let of = |kind, angle| Self { kind, per_node: arrangement.per_node(), angle };
        match *arrangement {
            Arrangement::Spread => of(TREE_ARRANGEMENT_SPREAD, 0.0),
            Arrangement::Spiral { divergence } => of(TREE_ARRANGEMENT_SPIRAL, divergence),
            Arrangement::Opposite => of(TREE_ARRANGEMENT_OPPOSITE, 0.0),
            Arrangement::Decussate => of(TREE_ARRANGEMENT_DECUSSATE, arrangement.turn()),
            Arrangement::Whorled { turn, .. } => of(TREE_ARRANGEMENT_WHORLED, turn),
            Arrangement::HorizontalDecussate { azimuth } => {
                of(TREE_ARRANGEMENT_HORIZONTAL, azimuth)
            }
            Arrangement::Custom { turn, .. } => of(TREE_ARRANGEMENT_CUSTOM, turn),
        }
    }

    /// `argument` is the field that holds it.
    pub(crate) fn rust(&self, argument: &str) -> Result<Arrangement> {
        let Self { kind, per_node, angle } = *self;
        Ok(match kind {
            TREE_ARRANGEMENT_SPREAD => Arrangement::Spread,
            TREE_ARRANGEMENT_SPIRAL => Arrangement::Spiral { divergence: angle },
            TREE_ARRANGEMENT_OPPOSITE => Arrangement::Opposite,
            TREE_ARRANGEMENT_DECUSSATE => Arrangement::Decussate,
            TREE_ARRANGEMENT_WHORLED => Arrangement::Whorled { per_node, turn: angle },
            TREE_ARRANGEMENT_HORIZONTAL => Arrangement::HorizontalDecussate { azimuth: angle },
            TREE_ARRANGEMENT_CUSTOM => Arrangement::Custom { per_node, turn: angle },
            other => {
                let name = format!("{argument}.kind");
                return Err(Failure::not_one_of(&name, other, "TREE_ARRANGEMENT_"));
            }
        })
    }
}

unsafe fn read_plain<T: Copy>(place: *const T, argument: &str) -> Result<T> {
    if place.is_null() {
        return Err(Failure::null(argument));
    }
    // SAFETY: not NULL, and there by contract; any bytes are a value of these structs.
    Ok(unsafe { place.read_unaligned() })
}

/// Checked.
pub(super) unsafe fn arrangement_of(arrangement: *const tree_arrangement) -> Result<Arrangement> {
    let found = unsafe { read_plain(arrangement, "arrangement") }?.rust("arrangement")?;
    found.validate()?;
    Ok(found)
}

/// Reads an arrangement by name: `spread`, `spiral` (144°), `golden` (137.5°), `opposite`, `decussate`, `whorl3` (any number),
/// `horizontal`, or `2:90` for two at a node and a turn of 90°. An angle in degrees may follow the names that have one:
/// `spiral:137.5`, `whorl3:45`, `horizontal:30`. `text` has `len` bytes or is `TREE_NUL_TERMINATED`.
/// `TREE_ERROR_UNKNOWN_NAME` for another name, `TREE_ERROR_PARAMETER` for a number out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_arrangement_from_text(
    text: *const c_char,
    len: usize,
    arrangement: *mut tree_arrangement,
) -> tree_status {
    call(|| {
        let found: Arrangement = unsafe { border::text(text, len, "text") }?.parse()?;
        unsafe { out_value(arrangement, tree_arrangement::of(&found), "arrangement") }
    })
}

/// Writes an arrangement as `tree_arrangement_from_text` reads it, angles in degrees to two places. Free the bytes, which
/// are UTF-8, with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_arrangement_to_text(
    arrangement: *const tree_arrangement,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let text = unsafe { arrangement_of(arrangement) }?.to_string();
        place.put(tree_bytes::new(text.into_bytes()));
        Ok(())
    })
}

/// The numbers behind an arrangement.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_arrangement_numbers {
    /// `sizeof(tree_arrangement_numbers)`.
    pub struct_size: usize,
    /// Branches at a node, n. 1 for `TREE_ARRANGEMENT_SPREAD`.
    pub per_node: u32,
    /// Turn from a node to the next, φ, in radians.
    pub turn: f32,
    /// Angle between two neighbours at a node, γ, in radians.
    pub spacing: f32,
    /// The azimuth that one privileged position of every node has, in radians, where `has_fixed` says so.
    pub fixed: f32,
    /// 1 where the arrangement fixes an azimuth, else 0.
    pub has_fixed: u32,
    /// 1 where branches have privileged positions at all, else 0.
    pub has_pattern: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_arrangement_numbers {
    const NAME: &'static str = "tree_arrangement_numbers";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Arrangement::Spread)
    }
}

impl tree_arrangement_numbers {
    fn of(arrangement: &Arrangement) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            per_node: arrangement.per_node(),
            turn: arrangement.turn(),
            spacing: arrangement.spacing(),
            fixed: arrangement.fixed().unwrap_or(0.0),
            has_fixed: arrangement.fixed().is_some().into(),
            has_pattern: arrangement.has_pattern().into(),
        }
    }
}

/// Tells the numbers behind an arrangement, and checks its ranges on the way. Set `numbers->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_arrangement_measure(
    arrangement: *const tree_arrangement,
    numbers: *mut tree_arrangement_numbers,
) -> tree_status {
    call(|| {
        let found = unsafe { arrangement_of(arrangement) }?;
        unsafe { write(numbers, "numbers", &tree_arrangement_numbers::of(&found)) }
    })
}

/// Where a branch may stand on its parent.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct tree_domain {
    /// Lowest and highest share of the parent's length, 0 to 1. Equal where the place is given.
    pub along: [f32; 2],
    /// First and last azimuth in radians, -1000 to 1000, in the sense that azimuth turns: 0 is the right side of the
    /// drawing, π the left. The last may be less than the first (the domain then passes 2π); 2π or more apart is all round.
    pub azimuth: [f32; 2],
}

impl tree_domain {
    pub(super) fn rust(self) -> Domain {
        Domain { along: self.along, azimuth: self.azimuth }
    }
}

/// The domain of a branch that was drawn: at the share `along` of the parent's length, within 45° of the side it was
/// drawn on, the left where `left` is not 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_domain_drawn(
    along: f32,
    left: u32,
    domain: *mut tree_domain,
) -> tree_status {
    call(|| {
        if !(0.0..=1.0).contains(&along) {
            let text = format!("along is {along}, allowed is 0 to 1");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let Domain { along, azimuth } = Domain::drawn(along, left != 0);
        unsafe { out_value(domain, tree_domain { along, azimuth }, "domain") }
    })
}

/// Says whether a place lies in a domain.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_domain_contains(
    domain: *const tree_domain,
    along: f32,
    azimuth: f32,
    inside: *mut u32,
) -> tree_status {
    call(|| {
        let domain = unsafe { read_plain(domain, "domain") }?.rust();
        unsafe { out_value(inside, domain.contains(along, azimuth).into(), "inside") }
    })
}

/// How far an azimuth lies outside a domain, in radians, 0 to π.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_domain_outside(
    domain: *const tree_domain,
    azimuth: f32,
    angle: *mut f32,
) -> tree_status {
    call(|| {
        let domain = unsafe { read_plain(domain, "domain") }?.rust();
        unsafe { out_value(angle, domain.outside(azimuth), "angle") }
    })
}

/// Where a branch stands on its parent.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct tree_site {
    /// Share of the parent's length, 0 to 1.
    pub along: f32,
    /// Azimuth round the parent in radians, 0 to 2π. 0 is the right side of the drawing, π the left.
    pub azimuth: f32,
    /// The node it stands at, counted from the parent's base; without a pattern its rank along the parent.
    pub node: u32,
}

impl tree_site {
    pub(super) fn of(site: &Site) -> Self {
        let Site { along, azimuth, node } = *site;
        Self { along, azimuth, node }
    }

    pub(super) fn rust(self) -> Site {
        let Self { along, azimuth, node } = self;
        Site { along, azimuth, node }
    }
}
