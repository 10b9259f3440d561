#![forbid(unsafe_code)]
#![doc = "Level of detail, and previews, of botanical trees."]
