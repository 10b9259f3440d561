//! All trees of a shard, one after another: each is parallel inside.

use crate::arguments::Request;
use crate::grow::{BakeError, grow};
use crate::manifest::{self, Line};
use crate::store::Folder;
use crate::{fingerprint, outputs};
use serde_json::json;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::Instant;
use tree_core::{Control, CoreError, file};

/// What became of a shard's trees.
#[derive(Default)]
pub(crate) struct Summary {
    /// Names, in the order of the manifest.
    pub(crate) baked: Vec<String>,
    /// Those that were finished before.
    pub(crate) skipped: Vec<String>,
    /// A sentence each, with the number of the line.
    pub(crate) failed: Vec<String>,
    seconds: f64,
    shard: String,
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { baked, skipped, failed, seconds, shard } = self;
        write!(
            f,
            "{shard}: {} baked, {} finished before, {} failed, {seconds:.1} s",
            baked.len(),
            skipped.len(),
            failed.len()
        )?;
        failed.iter().try_for_each(|failure| write!(f, "\n  {failure}"))
    }
}

/// Bakes what the request's shard has and is not finished. `say` hears of each tree as it is done.
///
/// # Errors
/// Only where the manifest cannot be read: what is wrong with single trees stands in the summary.
pub(crate) fn run(request: &Request, say: &dyn Fn(&str)) -> Result<Summary, CoreError> {
    let started = Instant::now();
    let control = Control::default().with_limits(request.limits);
    let text = file::read_text(&request.manifest, &control.limits)?;
    let inputs = request.manifest.parent().unwrap_or(Path::new(""));
    let rows = manifest::read(&text).into_iter().enumerate();
    let mut summary = Summary { shard: request.shard.to_string(), ..Summary::default() };
    for (_, (number, line)) in rows.filter(|(row, _)| request.shard.has(*row)) {
        let line = match line {
            Ok(line) => line,
            Err(error) => {
                summary.fail(format!("line {number}: {error}"), say);
                continue;
            }
        };
        match tree(&line, inputs, request, &control) {
            Ok(None) => summary.skipped.push(line.name),
            Ok(Some(done)) => {
                say(&format!("{}: {done}", line.name));
                summary.baked.push(line.name);
            }
            Err(error) => {
                summary.fail(format!("line {number}, {}: {error}", line.name), say);
            }
        }
    }
    summary.seconds = started.elapsed().as_secs_f64();
    Ok(summary)
}

impl Summary {
    fn fail(&mut self, sentence: String, say: &dyn Fn(&str)) {
        say(&sentence);
        self.failed.push(sentence);
    }
}

/// Bakes a tree, or finds that it is finished; what was done, in words.
fn tree(
    line: &Line,
    inputs: &Path,
    request: &Request,
    control: &Control,
) -> Result<Option<String>, BakeError> {
    let mut folder = Folder::new(&request.out, &line.name);
    let fingerprint = fingerprint::of_line(line, inputs, &control.limits)?;
    if folder.is_finished(&fingerprint) {
        return Ok(None);
    }
    if request.dry_run {
        return Ok(Some("would be baked".into()));
    }
    let started = Instant::now();
    folder.begin()?;
    // A defect in one tree is not to cost the others.
    let work = AssertUnwindSafe(|| {
        let grown = grow(line, inputs, control)?;
        outputs::write(line, &grown, &mut folder, control)
    });
    let outcome = catch_unwind(work).unwrap_or_else(|panic| Err(BakeError::Panic(said(&*panic))));
    let mut report = outcome.inspect_err(|_| folder.abandon())?;
    let seconds = started.elapsed().as_secs_f64();
    let triangles = report.get("triangles").map(ToString::to_string).unwrap_or_default();
    let done = format!("{seconds:.1} s, triangles {triangles}");
    report.insert("seconds".into(), json!(seconds));
    folder.finish(&fingerprint, report)?;
    Ok(Some(done))
}

fn said(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no message").into()
}
