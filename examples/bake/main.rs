//! A forest of unique trees with all their levels, baked from a manifest: on one machine, or in shards under Slurm or Kubernetes.
//!
//! `cargo run --release --example bake -- MANIFEST.jsonl [--out FOLDER] [--shard I --of N] [--memory GIB] [--dry-run]`
//!
//! A line of the manifest is a tree. Each gets a folder of its own, written file by file, whole or not at all, the report last. What
//! is finished is skipped, so a run that was cut goes on where it was. A bad line is reported, and the other trees are made. See docs/BAKING.md.

mod arguments;
mod fingerprint;
mod grow;
mod manifest;
mod outputs;
mod resize;
mod run;
mod shard;
mod store;

use arguments::Request;
use std::io::Write;
use std::process::ExitCode;

const USAGE: &str =
    "bake MANIFEST.jsonl [--out FOLDER] [--shard I --of N] [--memory GIB] [--dry-run]";

fn main() -> ExitCode {
    let environment = |name: &str| std::env::var(name).ok();
    let request = match Request::parse(std::env::args().skip(1), environment) {
        Ok(request) => request,
        Err(error) => {
            eprintln!("error: {error}\nusage: {USAGE}");
            return ExitCode::from(2);
        }
    };
    // Logs of jobs are often pipes that close early: that is no reason to stop.
    let say = |line: &str| drop(writeln!(std::io::stdout(), "{line}"));
    match run::run(&request, &say) {
        Ok(summary) => {
            say(&summary.to_string());
            if summary.failed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
