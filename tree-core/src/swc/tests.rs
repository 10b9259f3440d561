use super::*;
use crate::error::CoreError;
use crate::limits::{LimitError, Limits, Resource};
use crate::skeleton::Skeleton;
use crate::skeleton::tests::any_skeleton;
use glam::Vec3;
use proptest::prelude::*;

/// The file as it stands: +Y up, nothing moved.
const PLAIN: SwcOptions = SwcOptions {
    up: UpAxis::Y,
    scale: 1.0,
    base_at_origin: false,
    unknown_radius: UnknownRadius::Keep,
};

fn plain(text: &str) -> Result<SwcImport> {
    read(text, &PLAIN, &Limits::default())
}

/// Line and problem of a text that cannot be read.
fn fault(text: &str) -> (usize, SwcProblem) {
    match plain(text).unwrap_err() {
        CoreError::Swc { line, problem } => (line, problem),
        other => panic!("{other}"),
    }
}

fn bits(skeleton: &Skeleton) -> Vec<[u32; 4]> {
    let rows = skeleton.positions().iter().zip(skeleton.radii());
    rows.map(|(p, r)| [p.x, p.y, p.z, *r].map(f32::to_bits)).collect()
}

#[test]
fn files_in_the_wild_are_read_as_they_are() {
    let tidy = plain("1 3 0 0 0 2 -1\n2 3 0 1 0 1 1\n3 4 1 1 0 .5 2\n").unwrap();
    assert_eq!(tidy.types, [3, 3, 4]);
    assert_eq!(tidy.report, SwcReport::default());
    for text in [
        "1 3 0 0 0 2 -1\r\n2 3 0 1 0 1 1\r\n3 4 1 1 0 .5 2\r\n",
        "1 3 0 0 0 2 -1\r2 3 0 1 0 1 1\r3 4 1 1 0 .5 2",
        "\u{feff}\n\n1\t3\t0\t0\t0\t2\t-1\n \t \n2 3  0 1 0   1 1\n   3 4 1 1 0 .5 2",
        "1.0 3.0 0e0 -0 +0 2E0 -1.000\n2 3 0 1 0 1 1e0\n3 4 1 1 0 5e-1 2",
    ] {
        let import = plain(text).unwrap();
        assert_eq!(import.skeleton, tidy.skeleton, "{text:?}");
        assert_eq!(import.types, tidy.types);
    }
}

#[test]
fn a_number_a_hair_above_the_middle_of_two_f32_is_rounded_up() {
    // As an f64 it is the middle, 1 + 2⁻²⁴, which would then go to the even neighbour, 1.
    let import = plain("1 3 1.00000005960464477539062500000001 0 0 1 -1").unwrap();
    assert_eq!(import.skeleton.positions()[0].x, 1.0_f32.next_up());
}

#[test]
fn ids_come_in_any_order_and_size() {
    let text = "9 4 1 1 0 .5 7\n7 3 0 1 0 1 9223372036854775807\n9223372036854775807 1 0 0 0 2 -1";
    let import = plain(text).unwrap();
    assert_eq!(import.ids, [i64::MAX, 7, 9]);
    assert_eq!(import.types, [1, 3, 4]);
    assert_eq!(import.skeleton.radii(), [2.0, 1.0, 0.5]);
    assert_eq!(import.skeleton.parents()[1..], [0, 1]);
    assert!(import.report.reordered);
}

#[test]
fn comments_and_further_fields_are_reported() {
    let import = plain("# one \n1 3 0 0 0 0 -1 extra 8 # two\n#\n").unwrap();
    assert_eq!(import.report.comments, "one\ntwo\n\n");
    assert_eq!(import.report.n_rows_with_more_fields, 1);
    assert_eq!(import.report.n_unknown_radii, 1);
}

#[test]
fn each_bad_line_is_named_with_what_is_wrong_there() {
    use SwcProblem::*;
    let not_a_number = |field, found: &str| NotANumber { field, found: found.into() };
    for (text, line, problem) in [
        ("", 1, NoRows),
        ("# only\n# comments\n", 2, NoRows),
        ("\n1 3 0 0 0 1 1\n", 2, NoRoot),
        ("1 3 0 0 0 1 2\n2 3 0 0 0 1 1\n", 1, NoRoot),
        ("1 3 0 0 0 1 -1\n2 3 0 0", 2, Fields { found: 4 }),
        ("x 3 0 0 0 1 -1", 1, not_a_number("id", "x")),
        ("1 3.5 0 0 0 1 -1", 1, not_a_number("type", "3.5")),
        ("1 2147483648 0 0 0 1 -1", 1, not_a_number("type", "2147483648")),
        ("1 3 0 1,5 0 1 -1", 1, not_a_number("y", "1,5")),
        ("1 3 0 0 0 1 1e300", 1, not_a_number("parent", "1e300")),
        ("1 3 0 0 0 1 nan", 1, not_a_number("parent", "nan")),
        ("1 3 nan 0 0 1 -1", 1, NotFinite { field: "x" }),
        ("1 3 0 0 1e39 1 -1", 1, NotFinite { field: "z" }),
        ("1 3 0 0 0 inf -1", 1, NotFinite { field: "radius" }),
        ("1 3 0 0 0 1e999 -1", 1, NotFinite { field: "radius" }),
        ("1 3 0 0 0 -0.5 -1", 1, NegativeRadius { found: -0.5 }),
        ("-4 3 0 0 0 1 -1", 1, NegativeId { found: -4 }),
        ("5 3 0 0 0 1 -1\n\n5 3 0 0 0 1 5", 3, DuplicateId { id: 5, first_line: 1 }),
        ("5 3 0 0 0 1 -1\n6 3 0 0 0 1 -2", 2, UnknownParent { id: 6, parent: -2 }),
        ("5 3 0 0 0 1 -1\n6 3 0 0 0 1 1", 2, UnknownParent { id: 6, parent: 1 }),
        ("#\n1 3 0 0 0 1 -1\n2 3 0 0 0 1 -1", 3, SecondRoot { first_line: 2 }),
        ("1 3 0 0 0 1 -1\n8 3 0 0 0 1 8", 2, Cycle { id: 8 }),
        ("1 3 0 0 0 1 -1\n2 3 0 0 0 1 3\n\n3 3 0 0 0 1 3", 4, Cycle { id: 3 }),
    ] {
        assert_eq!(fault(text), (line, problem), "{text:?}");
    }
}

#[test]
fn a_long_field_is_not_repeated_whole() {
    let (_, problem) = fault(&format!("{} 3 0 0 0 1 -1", "ä".repeat(100_000)));
    assert!(problem.to_string().len() < 200, "{problem}");
}

#[test]
fn one_node_over_the_cap_is_refused() {
    let limits = Limits { nodes: 2, ..Default::default() };
    let text = write(&chain(2), &PLAIN).unwrap();
    assert!(read(&text, &PLAIN, &limits).is_ok());
    let text = write(&chain(3), &PLAIN).unwrap();
    assert!(matches!(
        read(&text, &PLAIN, &limits),
        Err(CoreError::Limit(LimitError { resource: Resource::Nodes, requested: 3, cap: 2 }))
    ));
}

#[test]
fn a_long_chain_upside_down_needs_no_stack() {
    let n = 200_000;
    let rows: Vec<String> = (0..n)
        .map(|i| format!("{i} 3 0 {i} 0 1 {}\n", if i + 1 == n { -1 } else { i + 1 }))
        .collect();
    let import = plain(&rows.concat()).unwrap();
    assert_eq!(import.skeleton.len(), n as usize);
    assert_eq!(import.ids[0], n - 1);
}

#[test]
fn axes_units_and_base_are_brought_to_ours() {
    // A trunk of 2 m in centimetres on a map grid, Z up, with a branch to the north (+Y).
    let text = "1 3 50000012.5 400000000 1000 10 -1\n2 3 50000012.5 400000000 1200 5 1\n\
                3 4 50000012.5 400000050 1200 1 2";
    let options = SwcOptions { scale: 0.01, ..Default::default() };
    let import = read(text, &options, &Limits::default()).unwrap();
    let found = import.skeleton.positions();
    assert_eq!(found, [Vec3::ZERO, Vec3::Y * 2.0, Vec3::new(0.0, 2.0, -0.5)]);
    assert_eq!(import.skeleton.radii(), [0.1, 0.05, 0.01]);
    assert_eq!(import.report.moved_by, [-500_000.125, -10.0, 4_000_000.0]);
}

#[test]
fn a_scale_out_of_range_is_refused_by_name() {
    for scale in [0.0, -1.0, 1e10, f64::NAN, f64::INFINITY] {
        let options = SwcOptions { scale, ..PLAIN };
        for error in [
            read("1 3 0 0 0 1 -1", &options, &Limits::default()).unwrap_err(),
            write(&chain(1), &options).unwrap_err(),
        ] {
            assert!(matches!(
                error,
                CoreError::Parameter(error) if error.field == "scale"
            ));
        }
    }
}

#[test]
fn unknown_radii_are_filled_from_both_sides() {
    let fill = |text: &str| {
        let options = SwcOptions { unknown_radius: UnknownRadius::Interpolate, ..PLAIN };
        let import = read(text, &options, &Limits::default()).unwrap();
        (
            import.skeleton.radii().to_vec(),
            import.report.n_unknown_radii,
            import.report.n_filled_radii,
        )
    };
    // Known 4 at 0 m and 1 at 3 m; unknown at 1 m, with an unknown twig and a thinner known one.
    let (radii, unknown, filled) = fill(
        "1 3 0 0 0 4 -1\n2 3 0 1 0 0 1\n3 3 0 3 0 1 2\n4 4 1 1 0 0 2\n5 4 0 1 1 .5 2\n6 3 0 9 0 0 3",
    );
    assert_eq!(radii, [4.0, 3.0, 1.0, 3.0, 0.5, 1.0]);
    assert_eq!((unknown, filled), (3, 3));
    // Nothing known below; then nothing known at all; then no way between.
    assert_eq!(fill("1 3 0 0 0 0 -1\n2 3 0 1 0 2 1").0, [2.0, 2.0]);
    assert_eq!(fill("1 3 0 0 0 0 -1\n2 3 0 1 0 0 1"), (vec![0.0, 0.0], 2, 0));
    assert_eq!(fill("1 3 0 0 0 4 -1\n2 3 0 0 0 0 1\n3 3 0 0 0 2 2").0, [4.0, 3.0, 2.0]);
}

#[test]
fn types_say_which_nodes_start_a_lateral() {
    let text = "1 3 0 0 0 1 -1\n2 4 1 1 0 .1 1\n3 3 0 1 0 .5 1\n4 3 2 2 0 .1 2\n";
    let import = plain(text).unwrap();
    let again = plain(&write(&import.skeleton, &PLAIN).unwrap()).unwrap();
    assert_eq!(again.types, import.types);
    assert_eq!(again.ids, [1, 2, 3, 4]);
}

#[test]
fn a_file_is_written_and_read_again() {
    let folder = std::env::temp_dir().join(format!("tree-core-swc-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("tree.swc");
    write_file(&path, &chain(3), &SwcOptions::default()).unwrap();
    let import = read_file(&path, &SwcOptions::default(), &Limits::default()).unwrap();
    assert_eq!(import.skeleton, chain(3));
    std::fs::remove_dir_all(&folder).unwrap();
    let error = write_file(&path, &chain(3), &SwcOptions::default()).unwrap_err();
    assert!(error.to_string().contains("tree.swc"), "{error}");
    let missing = read_file(&path, &SwcOptions::default(), &Limits::default());
    assert!(matches!(missing, Err(CoreError::Io { .. })));
}

/// Real scans, see SOURCES.md beside them. They are too large for the repository.
#[test]
fn scanned_trees_have_the_counts_that_their_source_states() {
    let folder =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/skeletons");
    if !folder.is_dir() {
        eprintln!("skipped: there is no {}", folder.display());
        return;
    }
    for (file, n_nodes, n_laterals, n_unknown) in
        [("puu1_reference.swc", 3966, 906, 661), ("cherry_plantscan3d.swc", 6128, 614, 152)]
    {
        let import =
            read_file(&folder.join(file), &SwcOptions::default(), &Limits::default()).unwrap();
        let SwcImport { skeleton, types, report, .. } = &import;
        skeleton.check().unwrap();
        assert_eq!(skeleton.len(), n_nodes);
        assert_eq!(types.iter().filter(|&&t| t == 4).count(), n_laterals);
        assert_eq!(report.n_unknown_radii, n_unknown);
        assert!(!report.reordered);
        assert_eq!(skeleton.positions()[0], Vec3::ZERO);
        assert!(skeleton.bounds().max.y > 3.0, "a tree stands up");

        let text = write(skeleton, &SwcOptions::default()).unwrap();
        let again = read(&text, &SwcOptions::default(), &Limits::default()).unwrap();
        assert_eq!(bits(&again.skeleton), bits(skeleton));

        let options =
            SwcOptions { unknown_radius: UnknownRadius::Interpolate, ..Default::default() };
        let filled = read_file(&folder.join(file), &options, &Limits::default()).unwrap();
        assert_eq!(filled.report.n_filled_radii, n_unknown);
        assert!(filled.skeleton.radii().iter().all(|&radius| radius > 0.0));
    }
}

fn chain(n_nodes: u32) -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.5).unwrap();
    for i in 1..n_nodes {
        builder.add(i - 1, Vec3::Y * i as f32, 0.5).unwrap();
    }
    builder.finish()
}

/// Any f32 that a skeleton may hold, the smallest and largest among them.
fn any_finite() -> impl Strategy<Value = f32> {
    use proptest::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

fn any_row() -> impl Strategy<Value = String> {
    let number = prop_oneof!["-?[0-9]{1,3}(\\.[0-9]{1,3})?", Just("nan".into()), "[0-9e.+-]{0,4}"];
    (0_i64..12, -1_i64..12, number, "[ \t]{1,2}")
        .prop_map(|(id, parent, x, gap)| format!("{id}{gap}3 {x} 0 {x} 1{gap}{parent}"))
}

fn assert_sound_or_refused(text: &str) {
    for up in [UpAxis::Y, UpAxis::Z] {
        for (scale, base_at_origin) in [(1.0, false), (1e9, true)] {
            let options = SwcOptions {
                up,
                scale,
                base_at_origin,
                unknown_radius: UnknownRadius::Interpolate,
            };
            match read(text, &options, &Limits::default()) {
                Ok(import) => {
                    import.skeleton.check().unwrap();
                    assert_eq!(import.types.len(), import.skeleton.len());
                    assert_eq!(import.ids.len(), import.skeleton.len());
                }
                Err(CoreError::Swc { line, .. }) => assert!(line >= 1),
                Err(other) => panic!("{other}"),
            }
        }
    }
}

proptest! {
    #[test]
    fn what_is_written_is_read_back_to_the_bit(skeleton in any_skeleton(100), z_up: bool, base: bool) {
        let options = SwcOptions {
            up: if z_up { UpAxis::Z } else { UpAxis::Y },
            base_at_origin: base,
            ..PLAIN
        };
        let text = write(&skeleton, &options).unwrap();
        let again = read(&text, &options, &Limits::default()).unwrap();
        prop_assert_eq!(&again.skeleton, &skeleton);
        prop_assert_eq!(bits(&again.skeleton), bits(&skeleton));
        prop_assert!(!again.report.reordered);
    }

    #[test]
    fn any_numbers_are_read_back_to_the_bit(
        rows in proptest::collection::vec((any_finite(), any_finite(), any_finite(), any_finite()), 1..20),
        z_up: bool,
    ) {
        let mut columns = crate::SkeletonColumns::default();
        for (i, (x, y, z, radius)) in rows.into_iter().enumerate() {
            columns.positions.push(Vec3::new(x, y, z));
            columns.radii.push(radius.abs());
            columns.parents.push(if i == 0 { crate::NO_PARENT } else { i as u32 - 1 });
        }
        let skeleton = Skeleton::try_from(columns).unwrap();
        let options = SwcOptions { up: if z_up { UpAxis::Z } else { UpAxis::Y }, ..PLAIN };
        let text = write(&skeleton, &options).unwrap();
        let again = read(&text, &options, &Limits::default()).unwrap();
        prop_assert_eq!(bits(&again.skeleton), bits(&skeleton));
    }

    #[test]
    fn other_units_change_the_last_digit_at_most(skeleton in any_skeleton(50), scale in 1e-4_f64..1e4) {
        let options = SwcOptions { scale, ..PLAIN };
        let text = write(&skeleton, &options).unwrap();
        let again = read(&text, &options, &Limits::default()).unwrap().skeleton;
        for (a, b) in again.positions().iter().zip(skeleton.positions()) {
            prop_assert!((*a - *b).length() <= b.length() * 1e-6);
        }
    }

    #[test]
    fn no_text_makes_the_reader_panic(
        noise in any::<String>(),
        like_swc in "([0-9]{1,2}[ \t]|[-+.eE#naif0-9\r\n ]){0,80}",
    ) {
        assert_sound_or_refused(&noise);
        assert_sound_or_refused(&like_swc);
    }

    #[test]
    fn no_bytes_make_the_reader_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        assert_sound_or_refused(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn no_rows_make_the_reader_panic(rows in proptest::collection::vec(any_row(), 0..12)) {
        assert_sound_or_refused(&rows.join("\n"));
    }
}
