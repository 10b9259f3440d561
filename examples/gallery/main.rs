//! Every picture of README and docs, by one command.
//!
//! `cargo run --release --example gallery -- [PART …] [--out FOLDER]`
//!
//! Parts are the names of the pictures (`presets`, `plastic`, …), all where none is named. The folder is `docs/pictures`.
//! Presets are drawn here, the rest by the other examples, whose pictures are put on sheets. What takes shared
//! data, which is not part of the project's packages, is left out where there is none.

mod others;
mod presets;
mod sheet;

use std::error::Error;
use std::path::PathBuf;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

fn main() -> Outcome {
    let (mut wanted, mut folder) = (Vec::new(), PathBuf::from("docs/pictures"));
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--out" => folder = arguments.next().ok_or("--out needs a folder")?.into(),
            part => wanted.push(part.to_owned()),
        }
    }
    let known: Vec<&str> = presets::PARTS.iter().chain(others::parts()).copied().collect();
    if let Some(unknown) = wanted.iter().find(|part| !known.contains(&part.as_str())) {
        return Err(format!("no part '{unknown}'; there are {}", known.join(", ")).into());
    }
    std::fs::create_dir_all(&folder)?;
    let parts = known.iter().filter(|part| wanted.is_empty() || wanted.iter().any(|w| w == *part));
    for part in parts {
        println!("== {part}");
        if presets::PARTS.contains(part) {
            presets::draw(part, &folder)?;
        } else {
            others::draw(part, &folder)?;
        }
    }
    Ok(())
}
