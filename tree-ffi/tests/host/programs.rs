//! Other people's programs: are they there, and what do they say in time?

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Longest that a host may take: they take seconds, and hang when something is wrong.
const PATIENCE: Duration = Duration::from_secs(180);

/// Whether all of these programs are installed. When one is not, says so past the test harness; with
/// `TREE_HOSTS` set, as CI does, that is a failure instead.
pub fn installed(programs: &[&str]) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let there = |program: &&&str| std::env::split_paths(&path).any(|at| at.join(program).is_file());
    let Some(missing) = programs.iter().find(|program| !there(program)) else { return true };
    skip(&format!("{missing} is not installed"));
    false
}

/// A notice that is seen although the test passes.
pub fn skip(why: &str) {
    assert!(std::env::var_os("TREE_HOSTS").is_none(), "{why}, and TREE_HOSTS is set");
    let _ = writeln!(std::io::stderr(), "skipped: {why}");
}

/// Where cargo put the library for this test.
pub fn library() -> PathBuf {
    std::env::current_exe().unwrap().parent().unwrap().to_path_buf()
}

/// An empty folder for a test's files.
pub fn work(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs a program to its end and gives back its exit status and what it printed, both streams; killed
/// when it takes too long.
pub fn finish(command: &mut Command, work: &Path) -> (Option<i32>, String) {
    let output = work.join("output.txt");
    // A file and no pipe: a full pipe would make the program wait for us.
    let file = File::create(&output).unwrap();
    let second = file.try_clone().unwrap();
    command.env("LD_LIBRARY_PATH", library()).stdin(Stdio::null()).stdout(file).stderr(second);
    let name = command.get_program().to_string_lossy().into_owned();
    let mut child = match command.spawn() {
        Ok(child) => child,
        Err(error) => panic!("{name}: {error}"),
    };
    let begin = Instant::now();
    loop {
        if let Ok(Some(status)) = child.try_wait() {
            return (status.code(), std::fs::read_to_string(&output).unwrap_or_default());
        }
        if begin.elapsed() > PATIENCE {
            let _ = child.kill();
            let _ = child.wait();
            let said = std::fs::read_to_string(&output).unwrap_or_default();
            panic!("{name} hangs; it said:\n{said}");
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// As [`finish`], for a program that must succeed.
pub fn succeed(command: &mut Command, work: &Path) -> String {
    let (status, said) = finish(command, work);
    let name = command.get_program().to_string_lossy();
    assert!(status == Some(0), "{name}: exit status {status:?}\n{said}");
    said
}
