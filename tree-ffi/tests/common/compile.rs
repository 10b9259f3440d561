//! The machine's compilers, and the programs that come of them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// What every C file must pass.
pub(crate) const C11: &[&str] = &["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-g"];
/// What every C++ file must pass.
pub(crate) const CPP17: &[&str] =
    &["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-g"];
/// gcc's checks of memory and of undefined behaviour; an error ends the program with a status.
pub(crate) const SANITIZE: &[&str] =
    &["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-fno-omit-frame-pointer"];

/// This package's folder.
pub(crate) fn here() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The repository's folder.
pub(crate) fn root() -> PathBuf {
    here().parent().expect("tree-ffi lies in the repository").to_path_buf()
}

/// Where cargo put the library for this test.
pub(crate) fn library_folder() -> PathBuf {
    let test = std::env::current_exe().expect("a test knows itself");
    test.parent().expect("it lies in a folder").to_path_buf()
}

/// A folder of this name for what a test makes, in the target folder.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("the target folder can be written");
    folder
}

/// Whether the machine has a program.
pub(crate) fn has(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// The files in `folder` with this ending, in order.
pub(crate) fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("a folder of sources")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == ending))
        .collect();
    files.sort();
    files
}

/// Compiles and links against the library; the program's path.
pub(crate) fn compile(compiler: &str, flags: &[&str], sources: &[PathBuf], name: &str) -> PathBuf {
    let program = folder("c_programs").join(name);
    let built = Command::new(compiler)
        .args(flags)
        .arg("-I")
        .arg(root().join("include"))
        .args(sources)
        .arg("-L")
        .arg(library_folder())
        .args(["-ltree_ffi", "-lm", "-lpthread", "-o"])
        .arg(&program)
        .output()
        .unwrap_or_else(|error| panic!("{compiler}: {error}"));
    assert!(built.status.success(), "{name}: {}", String::from_utf8_lossy(&built.stderr));
    program
}

/// A command that finds the library, in a folder of its own.
pub(crate) fn command(program: &Path) -> Command {
    let mut command = Command::new(program);
    on_its_own(&mut command, program);
    command
}

/// The program under valgrind: leaks, and all that reads or writes what it must not, end with status 9.
pub(crate) fn valgrind(program: &Path) -> Command {
    let mut command = Command::new("valgrind");
    command.args(["-q", "--leak-check=full", "--errors-for-leak-kinds=definite,indirect"]);
    command.args(["--error-exitcode=9", "--fair-sched=yes"]).arg(program);
    on_its_own(&mut command, program);
    command
}

fn on_its_own(command: &mut Command, program: &Path) {
    let name = program.file_name().expect("a program has a name").to_string_lossy();
    command.env("LD_LIBRARY_PATH", library_folder()).current_dir(folder(&format!("run_{name}")));
}

/// Runs it; fails with what it said unless it ends well.
pub(crate) fn run(command: &mut Command) -> String {
    let output = output(command);
    assert!(output.status.success(), "{command:?}: {}\n{}", output.status, said(&output));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

pub(crate) fn output(command: &mut Command) -> Output {
    command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"))
}

/// The last of what a program wrote.
pub(crate) fn said(output: &Output) -> String {
    let (out, err) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let all = format!("{out}{err}");
    let lines: Vec<_> = all.lines().collect();
    lines[lines.len().saturating_sub(80)..].join("\n")
}
