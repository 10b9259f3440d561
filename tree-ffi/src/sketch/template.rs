//! Templates: what is known of trees before one is sketched.

use crate::border::{Handle, call, free, out, tree_status};
use std::borrow::Cow;
use tree_model::sketch::template::Template;

/// Kinds of tree to guide a reconstruction by.
pub struct tree_templates(Cow<'static, [Template]>);

impl Handle for tree_templates {
    const NAME: &'static str = "tree_templates";
}

impl tree_templates {
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

/// Frees templates. What was made of them lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_free(templates: *mut tree_templates) -> tree_status {
    call(|| unsafe { free(templates, "templates") })
}
