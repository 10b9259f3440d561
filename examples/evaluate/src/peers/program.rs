//! Programs of others, and what they answer: one line of JSON.
//!
//! Whatever they do, evaluation goes on: one that is not installed, hangs, fails or prints something else is an
//! [`Absence`] that says so.

use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::ffi::OsStr;
use std::fmt;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// The status a script leaves with when what it needs is not installed.
const NOT_INSTALLED: i32 = 3;
/// Longest that one case may take.
const LIMIT: Duration = Duration::from_secs(30);
/// Between two looks at whether it has ended.
const STEP: Duration = Duration::from_millis(5);
/// How long what it said may take to arrive after it has ended.
const ARRIVAL: Duration = Duration::from_secs(1);
/// Most bytes that are read of what it says.
const SAID_MAX: u64 = 1 << 20;
/// Most letters of a complaint that are repeated.
const SHOWN: usize = 200;

/// Why a peer has no figures.
#[derive(Debug)]
pub(crate) enum Absence {
    /// Its program or package is not there: what was said.
    NotInstalled(Peer, String),
    /// It took longer than [`LIMIT`].
    Hangs(Peer),
    /// It ended badly, or said nothing that could be understood.
    Broken(Peer, String),
}

impl fmt::Display for Absence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotInstalled(peer, why) => {
                let Peer { name, install, .. } = peer;
                write!(f, "{name} is not installed ({why}); to have it: {install}")
            }
            Self::Hangs(peer) => {
                write!(f, "{} has no answer after {} s", peer.name, LIMIT.as_secs())
            }
            Self::Broken(peer, why) => write!(f, "{} does not work: {why}", peer.name),
        }
    }
}

/// What all peers tell.
#[derive(Deserialize)]
pub(crate) struct Told<T> {
    /// Of the fastest run.
    pub(crate) seconds: f64,
    /// Peak memory of the first run above that of the idle process.
    pub(crate) peak_bytes: Option<f64>,
    /// What else this one tells.
    #[serde(flatten)]
    pub(crate) more: T,
}

/// Nothing else.
#[derive(Deserialize)]
pub(crate) struct Nothing {}

/// A language that peers are written in, as this machine has it.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Language {
    /// `TREE_PEERS_PYTHON`, the one that `install.sh` made, or `python3`.
    Python,
    /// `TREE_PEERS_NODE` or `node`.
    Node,
}

impl Language {
    fn interpreter(self) -> PathBuf {
        let (variable, usual) = match self {
            Self::Python => ("TREE_PEERS_PYTHON", "python3"),
            Self::Node => ("TREE_PEERS_NODE", "node"),
        };
        let installed = folder().join("python/bin/python");
        match (self, std::env::var_os(variable)) {
            (_, Some(path)) => path.into(),
            (Self::Python, None) if installed.is_file() => installed,
            _ => usual.into(),
        }
    }
}

/// Where `install.sh` puts them: `TREE_PEERS` or `target/peers`.
fn folder() -> PathBuf {
    std::env::var_os("TREE_PEERS").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/peers"),
        PathBuf::from,
    )
}

/// A peer, and a script that runs it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Peer {
    pub(crate) name: &'static str,
    /// What installs it.
    pub(crate) install: &'static str,
    pub(crate) language: Language,
    pub(crate) script: &'static str,
}

impl Peer {
    /// Runs a case, and takes the last line it prints.
    ///
    /// # Errors
    /// [`Absence`], of whichever kind.
    pub(crate) fn ask<T: DeserializeOwned>(
        &self,
        arguments: &[&OsStr],
    ) -> Result<Told<T>, Absence> {
        let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers");
        let modules = std::env::var_os("TREE_PEERS_NODE_PATH")
            .map_or_else(|| folder().join("node_modules"), PathBuf::from);
        let mut command = Command::new(self.language.interpreter());
        command
            .arg(scripts.join(self.script))
            .args(arguments)
            .env("TREE_PEERS_NODE_PATH", modules)
            .env("PYTHONDONTWRITEBYTECODE", "1");
        let said = self.run(&mut command, LIMIT)?;
        let last = said.lines().rev().find(|line| !line.trim().is_empty()).unwrap_or_default();
        let told: Told<T> = serde_json::from_str(last)
            .map_err(|error| self.broken(format!("it says '{}' ({error})", short(last))))?;
        let sound = told.seconds.is_finite() && told.seconds > 0.0;
        sound.then_some(told).ok_or_else(|| self.broken(format!("it says '{}'", short(last))))
    }

    /// That it does not work, and why.
    pub(crate) fn broken(&self, why: impl fmt::Display) -> Absence {
        Absence::Broken(*self, why.to_string())
    }

    /// What the command says on its standard output.
    fn run(&self, command: &mut Command, limit: Duration) -> Result<String, Absence> {
        let mut child = command
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| {
                let program = command.get_program().to_string_lossy();
                Absence::NotInstalled(*self, format!("{program}: {error}"))
            })?;
        let said = listen(child.stdout.take());
        let complaints = listen(child.stderr.take());
        let started = Instant::now();
        let status = loop {
            match child.try_wait() {
                Ok(Some(status)) => break status,
                Ok(None) if started.elapsed() < limit => std::thread::sleep(STEP),
                other => {
                    // It may just have ended by itself.
                    let _ = child.kill();
                    let _ = child.wait();
                    return Err(match other {
                        Err(error) => self.broken(error),
                        Ok(_) => Absence::Hangs(*self),
                    });
                }
            }
        };
        if status.success() {
            return said
                .recv_timeout(ARRIVAL)
                .map_err(|_| self.broken("it does not end its output"));
        }
        let complaints = complaints.recv_timeout(ARRIVAL).unwrap_or_default();
        let why = complaints.lines().rev().find(|line| !line.trim().is_empty()).unwrap_or_default();
        Err(if status.code() == Some(NOT_INSTALLED) {
            Absence::NotInstalled(*self, short(why))
        } else {
            self.broken(format!("{status}: {}", short(why)))
        })
    }
}

/// Reads in a thread of its own, so that neither a full pipe nor one that others hold open stops us.
fn listen(from: Option<impl Read + Send + 'static>) -> Receiver<String> {
    let (send, receive) = channel();
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(from) = from {
            // What came before an error is still worth reading.
            let _ = from.take(SAID_MAX).read_to_end(&mut bytes);
        }
        // Nobody may wait for it any more.
        let _ = send.send(String::from_utf8_lossy(&bytes).into_owned());
    });
    receive
}

/// The beginning of a text, on one line.
fn short(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(SHOWN).collect()
}

/// A folder for what programs hand over, gone in the end.
pub(crate) struct Scratch(PathBuf);

impl Scratch {
    /// Makes one; `name` tells it from others of this process.
    ///
    /// # Errors
    /// When the system does not let it.
    pub(crate) fn new(name: &str) -> std::io::Result<Self> {
        let folder = std::env::temp_dir().join(format!("evaluate-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder)?;
        Ok(Self(folder))
    }

    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // Nothing hangs on a folder of temporary files that stays.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    const PEER: Peer = Peer {
        name: "peer",
        install: "pip install peer",
        language: Language::Python,
        script: "none",
    };

    fn sh(text: &str, limit: Duration) -> Result<String, Absence> {
        PEER.run(Command::new("sh").args(["-c", text]), limit)
    }

    #[test]
    fn what_a_program_says_comes_back() {
        assert_eq!(sh("echo one; echo two", LIMIT).unwrap(), "one\ntwo\n");
    }

    #[test]
    fn an_absent_program_and_an_absent_package_are_not_installed() {
        let program = PEER.run(&mut Command::new("/no/such/program"), LIMIT).unwrap_err();
        let package = sh("echo No module named m >&2; exit 3", LIMIT).unwrap_err();
        assert!(matches!(program, Absence::NotInstalled(..)), "{program}");
        assert!(
            package.to_string().ends_with("(No module named m); to have it: pip install peer"),
            "{package}"
        );
    }

    #[test]
    fn a_program_that_hangs_is_ended() {
        let hangs = sh("sleep 60", Duration::from_millis(50)).unwrap_err();
        assert!(matches!(hangs, Absence::Hangs(_)), "{hangs}");
    }

    #[test]
    fn a_program_that_fails_says_why() {
        let broken = sh("echo because >&2; exit 1", LIMIT).unwrap_err();
        assert!(broken.to_string().ends_with("because"), "{broken}");
    }

    #[test]
    fn a_flood_of_output_neither_blocks_nor_fills_memory() {
        let flood = sh("yes | head -c 3000000; exit 0", LIMIT);
        assert!(flood.is_err() || flood.unwrap().len() <= SAID_MAX as usize);
    }

    #[test]
    fn a_script_that_is_not_there_is_broken() {
        let told = PEER.ask::<Nothing>(&[]);
        assert!(matches!(told, Err(Absence::Broken(..) | Absence::NotInstalled(..))));
    }
}
