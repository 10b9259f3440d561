#![doc = "evaluate"]
fn main() {}
