//! The C ABI against the Rust it stands on: what a call costs, a whole oak both ways, and that meshes
//! are handed out without a copy.
//!
//! A C program (`bench.c`) is compiled against the release library and measured from within, in turn with
//! the same work in Rust, so that a busy machine is busy for both. The Rust side is a process of its own too
//! (this program again): one that has done other work keeps its heap, and takes fewer new pages.

use crate::table::{Aim, Row, Table};
use std::hint::black_box;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::Instant;
use tree_core::{Control, Seed};
use tree_mesh::{Look, MeshParams, build};
use tree_model::path::Preset;

type Outcome<T = ()> = Result<T, Box<dyn std::error::Error>>;

/// What the issue asks for: at most two percent more through C.
const OVERHEAD: f64 = 1.02;
/// Rounds of each comparison; odd, so that there is a middle one.
const ROUNDS: usize = 21;
/// The preset whose instructions are counted too, which takes half a minute.
const COUNTED: &str = "a";
/// Resident size may grow by so much from the 200th to the 1000th cycle: arenas of the allocator.
const GROWTH: f64 = 1.05;
/// Budgets that each piece of work is tried under, as shares of what it takes without one.
const BUDGETS: [f64; 6] = [0.1, 0.3, 0.6, 0.9, 1.1, 2.0];
/// Work under a budget may still take this much more than it: what is asked for between two checks.
const PEAK: f64 = 1.1;
/// A budget this many times what the work takes must do.
const ROOM: f64 = 4.0;

/// The flag under which this program answers for Rust as `bench.c` does for C.
pub(crate) const RUST_FLAG: &str = "--whole-in-rust";

pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    let mut c = Program::in_c()?;
    let mut rust = Program::in_rust()?;
    calls(table, &mut c)?;
    for preset in ["oak", "a", "g"] {
        whole(table, &mut c, &mut rust, preset)?;
    }
    fetches(table, &mut c)?;
    cycles(table, &mut c)?;
    ["grow", "leaves", "mesh", "picture", "glb"]
        .into_iter()
        .try_for_each(|work| budgets(table, &mut c, work))
}

fn calls(table: &mut Table, c: &mut Program) -> Outcome {
    let [nothing, view, refused] = c.ask("calls")?;
    let case = "one call through C";
    let mut row = |metric, ours, unit, aim| {
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
    };
    row("tree_abi_version", nothing, "ns", Aim::None);
    row("tree_mesh_surface", view, "ns", Aim::None);
    row("a refused NULL, with its text", refused, "ns", Aim::None);
    Ok(())
}

fn whole(table: &mut Table, c: &mut Program, rust: &mut Program, preset: &str) -> Outcome {
    let ask = format!("whole {preset}");
    // Once each for warm caches and pools.
    let [_, c_vertices] = c.ask(&ask)?;
    let [_, n_vertices] = rust.ask(&ask)?;
    if c_vertices != n_vertices {
        return Err(
            format!("{preset}: {c_vertices} vertices through C, {n_vertices} in Rust").into()
        );
    }
    let mut rounds = Vec::new();
    for round in 0..ROUNDS {
        // Who goes first changes, so that neither always finds the caches the other left.
        let (first, second) =
            if round % 2 == 0 { (&mut *rust, &mut *c) } else { (&mut *c, &mut *rust) };
        let ([one, _], [other, _]) = (first.ask::<2>(&ask)?, second.ask::<2>(&ask)?);
        rounds.push(if round % 2 == 0 { (one, other) } else { (other, one) });
    }
    let in_rust = middle(rounds.iter().map(|round| round.0));
    let ours = middle(rounds.iter().map(|round| round.1));
    // Of each round, so that what slows the machine for a while slows both.
    let ratio = middle(rounds.iter().map(|round| round.1 / round.0));
    let case = format!("preset {preset}: grow, mesh, free");
    table.row(&Row {
        case: &case,
        metric: "time (peer: through Rust)",
        paper: None,
        peer: Some(1e3 * in_rust),
        ours: 1e3 * ours,
        unit: "ms",
        aim: Aim::None,
    });
    table.row(&Row {
        case: &case,
        metric: "time, C over Rust",
        paper: None,
        peer: None,
        ours: ratio,
        unit: "×",
        aim: Aim::AtMost(OVERHEAD),
    });
    if preset != COUNTED {
        return Ok(());
    }
    let (through_c, through_rust) =
        rayon::join(|| c.instructions(&ask), || rust.instructions(&ask));
    if let (Some(through_c), Some(through_rust)) = (through_c, through_rust) {
        table.row(&Row {
            case: &case,
            metric: "instructions, C over Rust",
            paper: None,
            peer: None,
            ours: through_c / through_rust,
            unit: "×",
            aim: Aim::AtMost(OVERHEAD),
        });
    }
    Ok(())
}

/// Answers `whole PRESET`, line by line.
pub(crate) fn answer_in_rust() -> Outcome {
    for line in std::io::stdin().lines() {
        let line = line?;
        let preset = line.strip_prefix("whole ").ok_or("not a question")?;
        let start = Instant::now();
        let n_vertices = whole_in_rust(preset)?;
        println!("{:.9} {n_vertices}", start.elapsed().as_secs_f64());
    }
    Ok(())
}

fn whole_in_rust(preset: &str) -> Outcome<usize> {
    let control = Control::default();
    let grown = Preset::find(preset)?.params()?.grow(Seed(1), &control)?;
    let look = Look::built_in(grown.tree.species())?;
    let built = build(&grown.tree, &look, &MeshParams::default(), &control)?;
    Ok(black_box(&built.mesh).n_vertices())
}

fn fetches(table: &mut Table, c: &mut Program) -> Outcome {
    let [bytes, moved] = c.ask("fetch")?;
    let case = "1000 fetches of the oak's mesh";
    let mut row = |metric, ours, unit| {
        let aim = Aim::AtMost(0.0);
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
    };
    row("bytes taken for them", bytes, "bytes");
    row("pointers that moved", moved, "");
    Ok(())
}

fn cycles(table: &mut Table, c: &mut Program) -> Outcome {
    let [early, late, left] = c.ask("cycles")?;
    let case = "1000 trees made and freed";
    let mut row = |metric, ours, unit, most| {
        let aim = Aim::AtMost(most);
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
    };
    row("resident size, 1000th over 200th", late / early, "×", GROWTH);
    row("objects left", left, "", 0.0);
    Ok(())
}

/// One piece of work under budgets from too small to ample.
fn budgets(table: &mut Table, c: &mut Program, work: &str) -> Outcome {
    let mut try_under = |bytes: f64| -> Outcome<(f64, i32)> {
        let [peak, status] = c.ask(&format!("budget {work} {bytes:.0}"))?;
        match status as i32 {
            status @ (0 | 9 | 10) => Ok((peak, status)),
            other => Err(format!("{work}: status {other} under a budget of {bytes} bytes").into()),
        }
    };
    let (free, _) = try_under(0.0)?;
    let (mut worst, mut refused) = (0.0_f64, 0);
    for share in BUDGETS {
        let (peak, status) = try_under(share * free)?;
        worst = worst.max(peak / (share * free));
        refused += i32::from(status != 0);
    }
    let (_, roomy) = try_under(ROOM * free)?;
    let case = format!("{work}, {:.0} MB without a budget", free / 1e6);
    let mut row = |metric, ours, unit, aim| {
        table.row(&Row { case: &case, metric, paper: None, peer: None, ours, unit, aim });
    };
    row("worst peak over budget", worst, "×", Aim::AtMost(PEAK));
    row("refused, of six budgets", refused.into(), "", Aim::None);
    row("refused with four times the peak", f64::from(roomy != 0), "", Aim::AtMost(0.0));
    Ok(())
}

fn middle(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// A program that waits for the next question.
struct Program {
    path: PathBuf,
    arguments: &'static [&'static str],
    child: Child,
    questions: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Program {
    /// `bench.c`, compiled.
    fn in_c() -> Outcome<Self> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let library = release_library()?;
        let program = library.join("evaluate_ffi_bench");
        let built = Command::new("cc")
            .args(["-std=c11", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I"])
            .arg(root.join("include"))
            .arg(root.join("examples/evaluate/src/ffi/bench.c"))
            .arg("-L")
            .arg(&library)
            .arg("-ltree_ffi")
            .arg(format!("-Wl,-rpath,{}", library.display()))
            .arg("-o")
            .arg(&program)
            .status()
            .map_err(|error| format!("a C compiler named cc is needed: {error}"))?;
        if !built.success() {
            return Err("bench.c does not compile".into());
        }
        Self::start(program, &[])
    }

    /// This program, answering for Rust.
    fn in_rust() -> Outcome<Self> {
        Self::start(std::env::current_exe()?, &[RUST_FLAG])
    }

    fn start(path: PathBuf, arguments: &'static [&'static str]) -> Outcome<Self> {
        let mut child = Command::new(&path)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let questions = child.stdin.take().ok_or("no pipe")?;
        let answers = BufReader::new(child.stdout.take().ok_or("no pipe")?);
        Ok(Self { path, arguments, child, questions, answers })
    }

    /// Instructions that a fresh program of this kind takes for a question on one thread, counted by
    /// valgrind: the same in every run, whatever else the machine does. `None` where it is not installed.
    fn instructions(&self, question: &str) -> Option<f64> {
        let mut counted = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(&self.path)
            .args(self.arguments)
            .env("RAYON_NUM_THREADS", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .ok()?;
        writeln!(counted.stdin.take()?, "{question}").ok()?;
        let said = String::from_utf8(counted.wait_with_output().ok()?.stderr).ok()?;
        let line = said.lines().find(|line| line.contains("Collected"))?;
        line.split_whitespace().last()?.parse().ok()
    }

    /// One question, and the numbers that answer it.
    fn ask<const N: usize>(&mut self, question: &str) -> Outcome<[f64; N]> {
        writeln!(self.questions, "{question}")?;
        let mut line = String::new();
        self.answers.read_line(&mut line)?;
        let numbers: Vec<f64> =
            line.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
        numbers.try_into().map_err(|_| format!("{question}: the program says '{line}'").into())
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        // It ends by itself when its input does; a program that hangs must not outlive us.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Where the shared library lies: cargo builds it with this program, which depends on its crate.
fn release_library() -> Outcome<PathBuf> {
    let folder = std::env::current_exe()?.parent().ok_or("no folder")?.join("deps");
    let name = format!("{}tree_ffi{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    if folder.join(&name).is_file() {
        Ok(folder)
    } else {
        Err(format!("{name} is not in {}: start with cargo run", folder.display()).into())
    }
}
