//! What was asked for on the command line.

use crate::shard::{Shard, ShardError};
use std::path::PathBuf;
use std::str::FromStr;
use tree_core::Limits;

pub(crate) struct Request {
    pub(crate) manifest: PathBuf,
    pub(crate) out: PathBuf,
    pub(crate) shard: Shard,
    pub(crate) limits: Limits,
    /// Only say what would be done.
    pub(crate) dry_run: bool,
}

/// What is wrong with a command line.
#[derive(Debug, thiserror::Error)]
pub(crate) enum ArgumentError {
    #[error("no manifest was given")]
    NoManifest,
    #[error("'{0}' is not known, or one too many")]
    Unknown(String),
    #[error("{0} needs a value")]
    NoValue(String),
    #[error("{flag} needs a number that is not negative, not '{found}'")]
    Number { flag: String, found: String },
    #[error(transparent)]
    Shard(#[from] ShardError),
}

impl Request {
    /// Reads arguments, and from the environment which shard a job's task is.
    pub(crate) fn parse(
        mut arguments: impl Iterator<Item = String>,
        environment: impl Fn(&str) -> Option<String>,
    ) -> Result<Self, ArgumentError> {
        let (mut manifest, mut out) = (None, PathBuf::from("out/forest"));
        let (mut index, mut of) = (None, None);
        let (mut limits, mut dry_run) = (Limits::default(), false);
        while let Some(flag) = arguments.next() {
            let mut value = || arguments.next().ok_or_else(|| ArgumentError::NoValue(flag.clone()));
            match flag.as_str() {
                "--out" => out = value()?.into(),
                "--shard" => index = Some(number(&flag, &value()?)?),
                "--of" => of = Some(number(&flag, &value()?)?),
                "--memory" => limits = Limits::for_memory(gib(number(&flag, &value()?)?)),
                "--dry-run" => dry_run = true,
                _ if flag.starts_with('-') || manifest.is_some() => {
                    return Err(ArgumentError::Unknown(flag));
                }
                _ => manifest = Some(PathBuf::from(flag)),
            }
        }
        let manifest = manifest.ok_or(ArgumentError::NoManifest)?;
        let shard = Shard::find(index, of, environment)?;
        Ok(Self { manifest, out, shard, limits, dry_run })
    }
}

fn gib(number: u64) -> u64 {
    number.saturating_mul(1 << 30)
}

fn number<T: FromStr>(flag: &str, text: &str) -> Result<T, ArgumentError> {
    text.parse().map_err(|_| ArgumentError::Number { flag: flag.into(), found: text.into() })
}
