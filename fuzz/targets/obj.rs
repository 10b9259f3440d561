#![no_main]

use tree_mesh::io::obj;

// The OBJ and, behind a zero byte, its MTL.
libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let mut parts = data.splitn(2, |&byte| byte == 0);
    let (obj, mtl) = (parts.next().unwrap_or_default(), parts.next());
    let control = tree_fuzz::control();
    tree_fuzz::check(match mtl {
        Some(mtl) => obj::from_slices(obj, mtl, &control),
        None => obj::from_slice(obj, &control),
    });
});
