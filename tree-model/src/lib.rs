#![forbid(unsafe_code)]
#![doc = "Modelers: from what a person has to a botanical tree."]
