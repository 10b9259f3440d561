//! A forest baked from a manifest (`examples/bake`): cut runs go on, shards share the work, bad lines cost nobody but themselves.

#![allow(clippy::unwrap_used)]

#[path = "../examples/bake/arguments.rs"]
mod arguments;
#[path = "../examples/bake/fingerprint.rs"]
mod fingerprint;
#[path = "../examples/bake/grow.rs"]
mod grow;
#[path = "../examples/bake/manifest.rs"]
mod manifest;
#[path = "../examples/bake/outputs.rs"]
mod outputs;
#[path = "../examples/bake/resize.rs"]
mod resize;
#[path = "../examples/bake/run.rs"]
mod run;
#[path = "../examples/bake/shard.rs"]
mod shard;
#[path = "../examples/bake/store.rs"]
mod store;

use arguments::{ArgumentError, Request};
use manifest::LineError;
use run::Summary;
use shard::{Shard, ShardError};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime};

/// Quick trees: two that are pruned, one without leaves, one that is only wood and a stream.
const FOREST: &str = r#"{"name": "flower", "modeler": {"lsystem": "abop-1.26"}, "levels": 2, "views": 2}
{"name": "stick", "modeler": {"lsystem": "abop-1.24d"}, "outputs": ["mesh", "levels", "skeleton"]}

{"name": "drawn", "modeler": {"sketch": "sapling.json"}, "species": "maple", "bare": true, "outputs": ["mesh", "stream"]}
{"name": "snag", "modeler": {"mesh": "snag.obj"}, "scale": 2.0, "outputs": ["skeleton", "mesh"]}
"#;
/// Where a child process is to bake, and which folder has the manifest.
const CHILD: &str = "TREE_BAKE_CHILD";

/// A folder with a manifest and what it needs.
fn folder(name: &str, manifest: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("tree-bake-{}-{name}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("forest.jsonl"), manifest).unwrap();
    for data in ["sapling.json", "snag.obj"] {
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/bake/data").join(data);
        fs::copy(from, folder.join(data)).unwrap();
    }
    folder
}

fn request(folder: &Path, out: &str, more: &[&str]) -> Request {
    let (manifest, out) = (folder.join("forest.jsonl"), folder.join(out));
    let fixed = [manifest.to_str().unwrap(), "--out", out.to_str().unwrap()];
    let arguments = fixed.iter().chain(more).map(|&argument| argument.to_owned());
    Request::parse(arguments.collect::<Vec<_>>().into_iter(), |_| None).unwrap()
}

fn bake(folder: &Path, out: &str, more: &[&str]) -> Summary {
    run::run(&request(folder, out, more), &|_| ()).unwrap()
}

/// Every file but reports, which tell of seconds, by its path below `out`.
fn files(out: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for tree in fs::read_dir(out).unwrap().map(Result::unwrap) {
        for file in fs::read_dir(tree.path()).unwrap().map(Result::unwrap) {
            let name = file.file_name().into_string().unwrap();
            if name != store::REPORT && !name.ends_with(".tmp") {
                let path = format!("{}/{name}", tree.file_name().into_string().unwrap());
                files.insert(path, fs::read(file.path()).unwrap());
            }
        }
    }
    files
}

fn report(folder: &Path, tree: &str) -> serde_json::Value {
    let text = fs::read_to_string(folder.join("out").join(tree).join(store::REPORT)).unwrap();
    serde_json::from_str(&text).unwrap()
}

#[test]
fn a_line_gives_the_same_bytes_in_one_run_and_in_shards_that_share_all_trees() {
    let folder = folder("shards", FOREST);
    let whole = bake(&folder, "out", &[]);
    assert!(whole.failed.is_empty(), "{whole}");
    assert_eq!(whole.baked, ["flower", "stick", "drawn", "snag"]);
    let mut seen = BTreeSet::new();
    for index in ["0", "1", "2"] {
        let part = bake(&folder, "parts", &["--shard", index, "--of", "3"]);
        for name in part.baked {
            assert!(seen.insert(name.clone()), "{name} is in two shards");
        }
        assert!(part.skipped.is_empty() && part.failed.is_empty());
    }
    assert_eq!(seen.len(), 4);
    let (all, parts) = (files(&folder.join("out")), files(&folder.join("parts")));
    assert_eq!(all.keys().collect::<Vec<_>>(), parts.keys().collect::<Vec<_>>());
    assert!(all == parts, "the bytes differ");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_report_tells_of_what_lies_beside_it() {
    let folder = folder("report", FOREST);
    bake(&folder, "out", &[]);
    let flower = report(&folder, "flower");
    let levels = flower["triangles"]["levels"].as_array().unwrap();
    assert_eq!(levels.len(), 2);
    assert!(levels[0].as_u64() > levels[1].as_u64(), "triangles fall: {levels:?}");
    assert!(
        flower["nodes"].as_u64() > Some(10) && flower["leaves"].as_u64() > Some(10),
        "{flower}"
    );
    assert!(flower["seconds"].as_f64() > Some(0.0));
    // Branches fall where there are no leaves.
    let stick = report(&folder, "stick");
    assert_eq!(stick["leaves"], 0);
    let levels = stick["triangles"]["levels"].as_array().unwrap();
    assert!(levels.first().unwrap().as_u64() > levels.last().unwrap().as_u64(), "{levels:?}");
    let found = files(&folder.join("out"));
    for tree in ["flower", "stick", "drawn", "snag"] {
        let report = report(&folder, tree);
        let told = report["files"].as_object().unwrap();
        for (name, bytes) in told {
            let found = &found[&format!("{tree}/{name}")];
            assert_eq!(Some(found.len() as u64), bytes.as_u64(), "{tree}/{name}");
        }
        let there = found.keys().filter(|path| path.starts_with(&format!("{tree}/")));
        assert_eq!(there.count(), told.len(), "{tree} has files that its report does not name");
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn what_is_finished_is_skipped_and_what_is_not_is_made_again() {
    let folder = folder("resumed", FOREST);
    bake(&folder, "out", &[]);
    let first = files(&folder.join("out"));
    assert_eq!(bake(&folder, "out", &[]).skipped.len(), 4);
    let out = folder.join("out");

    // A file that is shorter than told; a report that never came; a line and an input that have changed.
    fs::write(out.join("flower/flower.glb"), "glTF").unwrap();
    fs::remove_file(out.join("stick").join(store::REPORT)).unwrap();
    let again = bake(&folder, "out", &[]);
    assert_eq!(
        (again.baked, again.skipped),
        (names(&["flower", "stick"]), names(&["drawn", "snag"]))
    );
    assert!(files(&out) == first, "the bytes differ");

    let other = FOREST.replace(r#"["skeleton", "mesh"]"#, r#"["skeleton"]"#);
    fs::write(folder.join("forest.jsonl"), other).unwrap();
    let drawing = fs::read_to_string(folder.join("sapling.json")).unwrap();
    fs::write(folder.join("sapling.json"), drawing.replace("186, 140", "190, 135")).unwrap();
    let changed = bake(&folder, "out", &[]);
    assert_eq!(
        (changed.baked, changed.skipped),
        (names(&["drawn", "snag"]), names(&["flower", "stick"]))
    );
    assert!(!out.join("snag/snag.glb").exists(), "an output that is no longer asked for");
    fs::remove_dir_all(folder).unwrap();
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|&name| name.to_owned()).collect()
}

#[test]
#[ignore = "a child of the test below"]
fn bakes_for_its_parent() {
    if let Ok(folder) = std::env::var(CHILD) {
        bake(Path::new(&folder), "out", &[]);
    }
}

#[test]
fn a_killed_run_leaves_whole_files_and_the_next_one_goes_on() {
    let line = FOREST.lines().next().unwrap();
    let lines: String = (0..40)
        .map(|i| line.replace("\"flower\",", &format!("\"flower-{i}\", \"seed\": {i},")) + "\n")
        .collect();
    let folder = folder("killed", &lines);
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "--ignored", "bakes_for_its_parent"])
        .env(CHILD, &folder)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let (third, patience) = (folder.join("out/flower-2/flower-2.glb"), Instant::now());
    while !third.exists() && patience.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(1));
    }
    // SIGKILL: nothing can be tidied up.
    child.kill().unwrap();
    child.wait().unwrap();
    let cut = files(&folder.join("out"));
    assert!(cut.len() >= 5 && cut.len() < 80, "cut in the middle: {} files", cut.len());
    for (path, bytes) in &cut {
        let said = u32::from_le_bytes(bytes[8..12].try_into().unwrap());
        assert_eq!(said as usize, bytes.len(), "{path} is cut");
    }
    // One more minute of work is enough to see that it goes on: the rest is the same.
    let short: String = lines.lines().take(4).map(|line| format!("{line}\n")).collect();
    fs::write(folder.join("forest.jsonl"), short).unwrap();
    let rest = bake(&folder, "out", &[]);
    assert!(rest.failed.is_empty() && rest.skipped.contains(&"flower-0".to_owned()), "{rest}");
    bake(&folder, "whole", &[]);
    let (whole, resumed) = (files(&folder.join("whole")), files(&folder.join("out")));
    assert!(whole.iter().all(|(path, bytes)| resumed.get(path) == Some(bytes)), "the bytes differ");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn bad_lines_are_reported_with_their_number_and_cost_nobody_else() {
    let bad = [
        (
            r#"{"name": "a", "modeler": {"lsystem": "fern"}, "sede": 3}"#,
            "unknown field `sede`, expected one of `name`",
        ),
        (
            r#"{"name": "b", "modeler": {"wind": "fern"}}"#,
            "unknown variant `wind`, expected one of `path`",
        ),
        (r#"{"name": "c""#, "column"),
        (r#"{"name": "../d", "modeler": {"lsystem": "fern"}}"#, "letters, digits"),
        (r#"{"name": "STICK", "modeler": {"lsystem": "fern"}}"#, "taken by line 1"),
        (
            r#"{"name": "e", "modeler": {"lsystem": "fern"}, "scale": -1}"#,
            "scale is -1, allowed is 0.001 to 1000",
        ),
        (
            r#"{"name": "f", "modeler": {"lsystem": "fern"}, "shares": [0.5, 0.5]}"#,
            "shares[1] is 0.5",
        ),
        (r#"{"name": "g", "modeler": {"lsystem": "fern"}, "height": 3}"#, "use scale"),
        (r#"{"name": "h", "modeler": {"lsystem": "ferns"}}"#, "ferns"),
        (r#"{"name": "i", "modeler": {"sketch": "gone.json"}}"#, "gone.json"),
        (r#"{"name": "j", "modeler": {"mesh": "sapling.json"}}"#, "sapling.json"),
        (r#"{"name": "k", "modeler": {"photo": []}}"#, "photo is empty"),
        (r#"{"name": "l", "modeler": {"growth": "oak"}, "species": "oka"}"#, "oka"),
    ];
    let stick =
        r#"{"name": "stick", "modeler": {"lsystem": "abop-1.24d"}, "outputs": ["skeleton"]}"#;
    let last = stick.replace("stick", "last");
    let lines: Vec<&str> = std::iter::once(stick)
        .chain(bad.iter().map(|(line, _)| *line))
        .chain(std::iter::once(last.as_str()))
        .collect();
    let folder = folder("bad", &lines.join("\n"));
    let summary = bake(&folder, "out", &[]);
    assert_eq!(summary.baked, ["stick", "last"]);
    assert_eq!(summary.failed.len(), bad.len(), "{summary}");
    for ((number, said), (_, expected)) in (2..).zip(&summary.failed).zip(bad) {
        assert!(said.starts_with(&format!("line {number}")), "{said}");
        assert!(said.contains(expected), "'{said}' does not say '{expected}'");
    }
    let mut left: Vec<_> = fs::read_dir(folder.join("out"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    left.sort();
    assert_eq!(left, ["last", "stick"], "folders of trees that were not made");
    assert_eq!(bake(&folder, "out", &[]).skipped, ["stick", "last"]);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn what_killed_runs_left_is_removed_once_it_is_old() {
    let folder = folder("old", FOREST.lines().nth(1).unwrap());
    let tree = folder.join("out/stick");
    fs::create_dir_all(&tree).unwrap();
    let [old, new] = [".tree-1-1.tmp", ".tree-1-2.tmp"].map(|name| tree.join(name));
    for path in [&old, &new] {
        fs::write(path, "half").unwrap();
    }
    let yesterday = SystemTime::now() - Duration::from_secs(86_400);
    fs::File::options().write(true).open(&old).unwrap().set_modified(yesterday).unwrap();
    bake(&folder, "out", &[]);
    assert!(!old.exists() && new.exists());
    fs::remove_dir_all(folder).unwrap();
}

/// A shard by a job's variables.
fn shard_of(of: Option<u64>, variables: &[(&str, &str)]) -> Result<Shard, ShardError> {
    let variable = |name: &str| {
        let found = variables.iter().find(|(known, _)| *known == name);
        found.map(|(_, value)| (*value).to_owned())
    };
    Shard::find(None, of, variable)
}

#[test]
fn jobs_tell_which_shard_they_are() {
    let slurm = |id, first, step, count| {
        shard_of(
            None,
            &[
                ("SLURM_ARRAY_TASK_ID", id),
                ("SLURM_ARRAY_TASK_MIN", first),
                ("SLURM_ARRAY_TASK_STEP", step),
                ("SLURM_ARRAY_TASK_COUNT", count),
            ],
        )
    };
    assert_eq!(slurm("7", "1", "2", "8"), Ok(Shard { index: 3, of: 8 }));
    assert_eq!(slurm("0", "0", "1", "1"), Ok(Shard { index: 0, of: 1 }));
    assert!(matches!(slurm("x", "0", "1", "1"), Err(ShardError::Number { .. })));
    // One task of an array that is run again.
    let again = [("SLURM_ARRAY_TASK_ID", "5"), ("SLURM_ARRAY_TASK_COUNT", "1")];
    assert_eq!(shard_of(Some(8), &again), Ok(Shard { index: 5, of: 8 }));
    let pod = [("JOB_COMPLETION_INDEX", "2"), ("JOB_COMPLETIONS", "3")];
    assert_eq!(shard_of(None, &pod), Ok(Shard { index: 2, of: 3 }));
    assert_eq!(shard_of(Some(4), &pod), Ok(Shard { index: 2, of: 4 }));
    assert!(matches!(shard_of(None, &pod[..1]), Err(ShardError::NoCount { .. })));
    assert_eq!(shard_of(Some(2), &pod), Err(ShardError::Range { index: 2, of: 2 }));
    assert_eq!(shard_of(None, &[]), Ok(Shard { index: 0, of: 1 }));
    assert_eq!(shard_of(Some(2), &[]), Err(ShardError::NoIndex));
}

#[test]
fn a_command_line_that_makes_no_sense_is_refused() {
    let parse = |line: &str| {
        let arguments: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        Request::parse(arguments.into_iter(), |_| None).err()
    };
    assert!(matches!(parse(""), Some(ArgumentError::NoManifest)));
    assert!(matches!(parse("a.jsonl --shard x"), Some(ArgumentError::Number { .. })));
    assert!(matches!(parse("a.jsonl --shard"), Some(ArgumentError::NoValue(_))));
    assert!(matches!(parse("a.jsonl b.jsonl"), Some(ArgumentError::Unknown(_))));
    assert!(matches!(parse("a.jsonl --shard 0"), Some(ArgumentError::Shard(_))));
    assert!(parse("a.jsonl --shard 0 --of 2 --memory 4 --dry-run").is_none());
}

#[test]
fn the_example_manifest_is_right_and_its_files_are_there() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/bake");
    let text = fs::read_to_string(folder.join("forest.jsonl")).unwrap();
    let rows = manifest::read(&text);
    assert_eq!(rows.len(), 8);
    for (number, line) in rows {
        let line: Result<_, LineError> = line;
        let line = line.unwrap_or_else(|error| unreachable!("line {number}: {error}"));
        assert!(line.inputs().iter().all(|path| folder.join(path).is_file()), "line {number}");
    }
}
