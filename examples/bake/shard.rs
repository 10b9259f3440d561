//! Which lines of the manifest are this process' own.

use std::fmt;

/// Every `of`-th tree, from the `index`-th: neighbours in a manifest are often alike, so every shard gets some of each kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shard {
    pub(crate) index: u64,
    pub(crate) of: u64,
}

/// Why it cannot be told which shard this is.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
pub(crate) enum ShardError {
    #[error("shard {index} of {of}: shards are counted from 0, the last is --of less one")]
    Range { index: u64, of: u64 },
    #[error(
        "{index} says this is one shard of several, nothing says of how many: give --of N, or set {count}"
    )]
    NoCount { index: &'static str, count: &'static str },
    #[error("--of needs --shard, or a Slurm array or an indexed Kubernetes job to run in")]
    NoIndex,
    #[error("{name} is '{found}', a number is needed")]
    Number { name: &'static str, found: String },
}

impl Shard {
    /// By what was given, else by a Slurm array's variables, else by those of an indexed Kubernetes job. All there is, where
    /// nothing says otherwise.
    ///
    /// A Slurm array may begin anywhere and step, `--array=1-64`, as long as the number of shards comes from Slurm; when it is
    /// given by `--of`, task numbers are shards, from 0, so that single ones can be run again.
    pub(crate) fn find(
        index: Option<u64>,
        of: Option<u64>,
        environment: impl Fn(&str) -> Option<String>,
    ) -> Result<Self, ShardError> {
        let variable = |name: &'static str| match environment(name) {
            None => Ok(None),
            Some(found) => match found.trim().parse::<u64>() {
                Ok(number) => Ok(Some(number)),
                Err(_) => Err(ShardError::Number { name, found }),
            },
        };
        if let Some(index) = index {
            let missing = ShardError::NoCount { index: "--shard", count: "--of" };
            return Self { index, of: of.ok_or(missing)? }.checked();
        }
        if let Some(task) = variable("SLURM_ARRAY_TASK_ID")? {
            let count = "SLURM_ARRAY_TASK_COUNT";
            let missing = ShardError::NoCount { index: "SLURM_ARRAY_TASK_ID", count };
            return match (of, variable(count)?) {
                (Some(of), _) => Self { index: task, of }.checked(),
                (None, Some(of)) => {
                    let first = variable("SLURM_ARRAY_TASK_MIN")?.unwrap_or(0);
                    let step = variable("SLURM_ARRAY_TASK_STEP")?.unwrap_or(1).max(1);
                    Self { index: task.saturating_sub(first) / step, of }.checked()
                }
                (None, None) => Err(missing),
            };
        }
        if let Some(index) = variable("JOB_COMPLETION_INDEX")? {
            let count = "JOB_COMPLETIONS";
            let missing = ShardError::NoCount { index: "JOB_COMPLETION_INDEX", count };
            let of = of.map_or_else(|| variable(count), |of| Ok(Some(of)))?;
            return Self { index, of: of.ok_or(missing)? }.checked();
        }
        match of {
            None | Some(1) => Ok(Self { index: 0, of: 1 }),
            Some(_) => Err(ShardError::NoIndex),
        }
    }

    fn checked(self) -> Result<Self, ShardError> {
        let Self { index, of } = self;
        if index < of { Ok(self) } else { Err(ShardError::Range { index, of }) }
    }

    /// Whether the `row`-th entry of the manifest, from 0, is this shard's.
    pub(crate) fn has(self, row: usize) -> bool {
        row as u64 % self.of == self.index
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "shard {} of {}", self.index, self.of)
    }
}
