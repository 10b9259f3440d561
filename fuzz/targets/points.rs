#![no_main]

use tree_mesh::io::points;

// The first byte picks the reader. A cloud that was read becomes trees or a typed error.
libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let Some((&reader, bytes)) = data.split_first() else { return };
    let control = tree_fuzz::control();
    let read = match reader % 2 {
        0 => points::from_ply(bytes, &control),
        _ => points::from_text(bytes, &control),
    };
    let Ok(cloud) = read else { return };
    tree_fuzz::scan(&cloud.positions, &control);
});
