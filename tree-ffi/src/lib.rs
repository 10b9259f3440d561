#![doc = "The C ABI."]
