//! Templates: what is known of trees before one is sketched.

use super::drawing::at;
use super::exemplar::tree_main_branch_params;
use super::{document, in_document};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, TREE_ERROR_UNKNOWN_NAME, Versioned, call, free,
    get, init, out, out_value, read, read_or_default, text, tree_status, tree_str, write,
};
use crate::control::{limits, run, tree_control};
use crate::io::tree_bytes;
use crate::mesh::column;
use crate::tree::tree_tree;
use std::borrow::Cow;
use std::ffi::c_char;
use std::ptr::null;
use tree_model::sketch::Normal;
use tree_model::sketch::template::{
    DIRECTION_BINS, Template, TemplateParams, TemplateView, parse, to_text,
};

/// Kinds of tree to guide a reconstruction by.
pub struct tree_templates(Cow<'static, [Template]>);

impl Handle for tree_templates {
    const NAME: &'static str = "tree_templates";
}

impl tree_templates {
    pub(crate) fn new(templates: Vec<Template>) -> Self {
        Self(Cow::Owned(templates))
    }

    pub(crate) fn rust(&self) -> &[Template] {
        &self.0
    }
}

/// The templates shipped: twenty trees of different habit. Free them with `tree_templates_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_builtin(
    templates: *mut *mut tree_templates,
) -> tree_status {
    call(|| {
        let place = unsafe { out(templates, "templates") }?;
        place.put(tree_templates(Cow::Borrowed(Template::builtin()?)));
        Ok(())
    })
}

/// Reads templates from text, `text` of `len` bytes or `TREE_NUL_TERMINATED`, as `tree_templates_to_text` writes it.
/// `control` may be NULL; only its limits matter. Free the templates with `tree_templates_free`. `TREE_ERROR_FORMAT`
/// names the line and says what is wrong with it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_from_text(
    text: *const c_char,
    len: usize,
    control: *const tree_control,
    templates: *mut *mut tree_templates,
) -> tree_status {
    call(|| {
        let place = unsafe { out(templates, "templates") }?;
        let text = unsafe { document(text, len, &limits(control)?, "text") }?;
        let read = unsafe { run(control, |_| parse(text).map_err(in_document)) }?;
        place.put(tree_templates::new(read));
        Ok(())
    })
}

/// Writes templates as text, some kilobytes for each. Free the bytes, which are UTF-8, with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_to_text(
    templates: *const tree_templates,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let text = to_text(unsafe { get(templates, "templates") }?.rust());
        place.put(tree_bytes::new(text.into_bytes()));
        Ok(())
    })
}

/// How a template is measured. Begin with `tree_template_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_template_params {
    /// `sizeof(tree_template_params)`.
    pub struct_size: usize,
    /// Which branches are main ones; NULL for the default.
    pub main: *const tree_main_branch_params,
    /// Views over half a turn, 1 to 180. Default 8, so with mirror images one every 22.5°.
    pub views: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_template_params {
    const NAME: &'static str = "tree_template_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let views = TemplateParams::default().views;
        Self { struct_size: size_of::<Self>(), main: null(), views, reserved: 0 }
    }
}

impl tree_template_params {
    unsafe fn rust(&self) -> Result<TemplateParams> {
        let main = unsafe { read_or_default(self.main, "params.main") }?.rust()?;
        Ok(TemplateParams { views: self.views, main })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_template_params_init(
    params: *mut tree_template_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_template_params_check(
    params: *const tree_template_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust() }?.validate()?))
}

/// Measures one template of any tree, which grows along +Y: an exemplar of your own. `name` and `species` are one line of
/// text each, of `name_len` and `species_len` bytes or `TREE_NUL_TERMINATED`; the species names its leaves. `params` and
/// `control` may be NULL. Free the template with `tree_templates_free`; `tree_templates_join` puts it to others.
/// `TREE_ERROR_INVALID` for trees without extent, height or branches.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_of_tree(
    name: *const c_char,
    name_len: usize,
    species: *const c_char,
    species_len: usize,
    tree: *const tree_tree,
    params: *const tree_template_params,
    control: *const tree_control,
    templates: *mut *mut tree_templates,
) -> tree_status {
    call(|| {
        let place = unsafe { out(templates, "templates") }?;
        let name = unsafe { text(name, name_len, "name") }?;
        let species = unsafe { text(species, species_len, "species") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let params = unsafe { read_or_default(params, "params")?.rust() }?;
        let body = |control: &_| Ok(Template::of_tree(name, species, tree, &params, control)?);
        let made = unsafe { run(control, body) }?;
        place.put(tree_templates::new(vec![made]));
        Ok(())
    })
}

/// Templates and others after them, copied. Free them with `tree_templates_free`. `TREE_ERROR_INVALID` where two have one
/// name.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_join(
    templates: *const tree_templates,
    others: *const tree_templates,
    joined: *mut *mut tree_templates,
) -> tree_status {
    call(|| {
        let place = unsafe { out(joined, "joined") }?;
        let templates = unsafe { get(templates, "templates") }?.rust();
        let others = unsafe { get(others, "others") }?.rust();
        let known = |other: &&Template| templates.iter().any(|own| own.name == other.name);
        if let Some(other) = others.iter().find(known) {
            let text = format!("there are two templates called '{}'", other.name);
            return Err(Failure::new(TREE_ERROR_INVALID, text));
        }
        place.put(tree_templates::new([templates, others].concat()));
        Ok(())
    })
}

/// Number of templates.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_count(
    templates: *const tree_templates,
    n_templates: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(templates, "templates") }?.rust().len();
        unsafe { out_value(n_templates, n, "n_templates") }
    })
}

/// Index of the template called `name` (`len` bytes, or `TREE_NUL_TERMINATED`). `TREE_ERROR_UNKNOWN_NAME` lists the names
/// there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_find(
    templates: *const tree_templates,
    name: *const c_char,
    len: usize,
    index: *mut usize,
) -> tree_status {
    call(|| {
        let templates = unsafe { get(templates, "templates") }?.rust();
        let name = unsafe { text(name, len, "name") }?;
        let Some(found) = templates.iter().position(|template| template.name == name) else {
            let known: Vec<_> = templates.iter().map(|template| template.name.as_str()).collect();
            let text = format!("no template is called '{name}'; known are {}", known.join(", "));
            return Err(Failure::new(TREE_ERROR_UNKNOWN_NAME, text));
        };
        unsafe { out_value(index, found, "index") }
    })
}

/// A template.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_template_view {
    /// `sizeof(tree_template_view)`.
    pub struct_size: usize,
    /// What it is called.
    pub name: tree_str,
    /// The species whose leaves it bears, as `tree_finish_params_find` takes it where it is built in.
    pub species: tree_str,
    /// Height of the exemplar in metres: what a drawing is scaled to unless its height is given.
    pub height: f32,
    /// Radius of the trunk's base over the height, 0 to 1.
    pub slenderness: f32,
    /// Number of orders of axes that have parameters of their own.
    pub n_orders: usize,
    /// Number of views; see `tree_templates_side`.
    pub n_views: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_template_view {
    const NAME: &'static str = "tree_template_view";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            species: tree_str::EMPTY,
            height: 0.0,
            slenderness: 0.0,
            n_orders: 0,
            n_views: 0,
        }
    }
}

/// Views a template. `index` is below `tree_templates_count`. Set `view->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_view(
    templates: *const tree_templates,
    index: usize,
    view: *mut tree_template_view,
) -> tree_status {
    call(|| {
        let found = at(unsafe { get(templates, "templates") }?.rust(), index, "templates")?;
        let value = tree_template_view {
            name: tree_str::of(&found.name),
            species: tree_str::of(&found.species),
            height: found.height,
            slenderness: found.slenderness,
            n_orders: found.omega.orders.len(),
            n_views: found.views.len(),
            ..tree_template_view::default_value()
        };
        unsafe { write(view, "view", &value) }
    })
}

/// Number of shares in `directions` of a `tree_template_side`.
pub const TREE_DIRECTION_BINS: usize = 12;
const _: () = assert!(TREE_DIRECTION_BINS == DIRECTION_BINS);

/// What a template looks like from one side.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_template_side {
    /// `sizeof(tree_template_side)`.
    pub struct_size: usize,
    /// Where the eye stands round the trunk, in radians, 0 to 2π: 0 on +Z, a quarter turn on +X.
    pub yaw: f32,
    /// Mean and standard deviation of the natural logarithm of a segment's length over that of the one below. NaN where
    /// there are no forks.
    pub scale: [f32; 2],
    /// The same of the angle in radians at which the branch that bends least leaves the segment below.
    pub alpha: [f32; 2],
    /// The same of all other branches.
    pub beta: [f32; 2],
    /// 0.
    pub reserved: u32,
    /// `TREE_DIRECTION_BINS` shares of the branches' length: what goes straight up comes first, straight down last.
    pub directions: *const f32,
    /// Footprint of crown and branches without the root branch: `TREE_FOOTPRINT_DIRECTIONS` distances.
    pub crown: *const f32,
    /// Footprint of the branches alone, as many.
    pub branches: *const f32,
    /// Number of points of the silhouette.
    pub n_silhouette: usize,
    /// Outline of the crown, two floats for each point, in metres, y up, the tree's base at the origin of y.
    pub silhouette: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_template_side {
    const NAME: &'static str = "tree_template_side";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            yaw: 0.0,
            scale: [0.0; 2],
            alpha: [0.0; 2],
            beta: [0.0; 2],
            reserved: 0,
            directions: null(),
            crown: null(),
            branches: null(),
            n_silhouette: 0,
            silhouette: null(),
        }
    }
}

impl tree_template_side {
    fn of(view: &TemplateView) -> Self {
        let pair = |normal: Option<Normal>| {
            normal.map_or([f32::NAN; 2], |normal| [normal.mean, normal.deviation])
        };
        Self {
            yaw: view.yaw,
            scale: pair(view.shape.scale),
            alpha: pair(view.shape.alpha),
            beta: pair(view.shape.beta),
            directions: column(&view.directions.0),
            crown: column(view.crown.distances()),
            branches: column(view.branches.distances()),
            n_silhouette: view.silhouette.len(),
            silhouette: column(&view.silhouette).cast(),
            ..Self::default_value()
        }
    }
}

/// Views what a template looks like from one side. `index` is below `tree_templates_count`, `number` below `n_views` of
/// the template. Set `side->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_side(
    templates: *const tree_templates,
    index: usize,
    number: usize,
    side: *mut tree_template_side,
) -> tree_status {
    call(|| {
        let found = at(unsafe { get(templates, "templates") }?.rust(), index, "templates")?;
        let view = at(&found.views, number, "views")?;
        unsafe { write(side, "side", &tree_template_side::of(view)) }
    })
}

/// Frees templates. What was made of them lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_free(templates: *mut tree_templates) -> tree_status {
    call(|| unsafe { free(templates, "templates") })
}
