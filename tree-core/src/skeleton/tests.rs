use super::*;
use proptest::prelude::*;

/// Random valid columns, leaning to the nasty: doubles, whorls, long chains, zero radii.
pub(crate) fn any_skeleton(max_nodes: usize) -> impl Strategy<Value = Skeleton> {
    let node = (0.0_f32..1.0, prop_oneof![Just(0.0_f32), -5.0_f32..5.0], 0.0_f32..1.0, 0_u8..4);
    proptest::collection::vec(node, 0..max_nodes).prop_map(|rows| {
        let mut builder = Skeleton::builder(Vec3::ZERO, 1.0).unwrap();
        for (pick, shift, radius, habit) in rows {
            let last = builder.len() as u32 - 1;
            let parent = match habit {
                0 => last,
                1 => 0,
                _ => (pick * (last + 1) as f32) as u32,
            }
            .min(last);
            let position = Vec3::new(shift, shift * pick, radius);
            builder.add(parent, position, if habit == 3 { 0.0 } else { radius }).unwrap();
        }
        builder.finish()
    })
}

fn fork() -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 1.0).unwrap();
    let top = builder.add(0, Vec3::Y, 0.9).unwrap();
    builder.add(top, Vec3::new(0.0, 3.0, 0.0), 0.5).unwrap();
    builder.add(top, Vec3::new(1.0, 1.0, 0.0), 0.7).unwrap();
    builder.finish()
}

#[test]
fn columns_with_a_nan_are_refused_by_row() {
    let error =
        Skeleton::from_columns(vec![Vec3::ZERO, Vec3::NAN], vec![1.0, 1.0], vec![NO_PARENT, 0])
            .unwrap_err();
    assert!(matches!(error, CoreError::NotFinite { field: "positions", index: 1 }));
}

#[test]
fn an_infinite_or_negative_radius_is_refused_by_row() {
    let make = |radius| {
        Skeleton::from_columns(vec![Vec3::ZERO, Vec3::Y], vec![1.0, radius], vec![NO_PARENT, 0])
            .unwrap_err()
    };
    assert!(matches!(make(f32::INFINITY), CoreError::NotFinite { field: "radii", index: 1 }));
    assert!(matches!(make(-0.5), CoreError::OutOfRange { field: "radii", index: 1, .. }));
}

#[test]
fn no_nodes_are_refused() {
    let error = Skeleton::from_columns(vec![], vec![], vec![]).unwrap_err();
    assert!(matches!(error, CoreError::Empty { what: "skeleton" }));
}

#[test]
fn columns_of_different_length_are_refused() {
    let error =
        Skeleton::from_columns(vec![Vec3::ZERO], vec![1.0], vec![NO_PARENT, 0]).unwrap_err();
    assert!(matches!(error, CoreError::Length { field: "positions", found: 1, expected: 2 }));
}

#[test]
fn a_second_root_and_a_late_parent_are_refused_by_row() {
    let make = |parents: [u32; 3]| {
        Skeleton::from_columns(vec![Vec3::ZERO; 3], vec![1.0; 3], parents.to_vec()).unwrap_err()
    };
    assert!(matches!(make([NO_PARENT, 0, NO_PARENT]), CoreError::SecondRoot { node: 2 }));
    assert!(matches!(make([NO_PARENT, 2, 0]), CoreError::ParentOrder { node: 1, parent: 2 }));
    assert!(matches!(make([NO_PARENT, 1, 0]), CoreError::ParentOrder { node: 1, parent: 1 }));
    assert!(matches!(make([2, 0, 0]), CoreError::RootHasParent { parent: 2 }));
}

#[test]
fn a_cycle_in_unordered_rows_is_named() {
    let make = |parents: Vec<u32>| {
        let n = parents.len();
        Skeleton::from_unordered(vec![Vec3::ZERO; n], vec![1.0; n], parents).unwrap_err()
    };
    assert!(matches!(make(vec![NO_PARENT, 2, 1, 1]), CoreError::Cycle { node: 1 | 2 }));
    assert!(matches!(make(vec![1, 0]), CoreError::NoRoot));
    assert!(matches!(make(vec![0]), CoreError::NoRoot));
    assert!(matches!(make(vec![NO_PARENT, 9]), CoreError::ParentOrder { node: 1, parent: 9 }));
}

#[test]
fn the_builder_adds_nothing_when_it_refuses() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 1.0).unwrap();
    assert!(builder.add(5, Vec3::Y, 1.0).is_err());
    assert!(builder.add(0, Vec3::NAN, 1.0).is_err());
    assert!(builder.add(0, Vec3::Y, f32::NAN).is_err());
    assert_eq!(builder.finish().len(), 1);
    let bad_root = Skeleton::builder(Vec3::NAN, 1.0).unwrap_err();
    assert!(matches!(bad_root, CoreError::NotFinite { field: "positions", index: 0 }));
    assert!(Skeleton::builder(Vec3::ZERO, -1.0).is_err());
}

#[test]
fn a_single_root_is_a_skeleton_with_every_view() {
    let single = Skeleton::builder(Vec3::X, 0.1).unwrap().finish();
    assert!(single.children().is_tip(0));
    assert_eq!(single.axes(Continuation::default()).len(), 1);
    assert_eq!(single.distances_to_tip(), [0.0]);
    assert_eq!(single.subtree_sizes(), [1]);
    assert_eq!(single.tip_counts(), [1]);
}

#[test]
fn lengths_and_counts_of_a_fork() {
    let skeleton = fork();
    assert_eq!(skeleton.distances_to_root(), [0.0, 1.0, 3.0, 2.0]);
    assert_eq!(skeleton.distances_to_tip(), [3.0, 2.0, 0.0, 0.0]);
    assert_eq!(skeleton.subtree_sizes(), [4, 3, 1, 1]);
    assert_eq!(skeleton.tip_counts(), [2, 2, 1, 1]);
}

#[test]
fn each_rule_continues_the_axis_by_its_own_measure() {
    let trunk = |rule| fork().axes(rule).get(0).unwrap().nodes.to_vec();
    assert_eq!(trunk(Continuation::Thickest), [0, 1, 3]);
    assert_eq!(trunk(Continuation::Longest), [0, 1, 2]);
    assert_eq!(trunk(Continuation::Straightest), [0, 1, 2]);
}

#[test]
fn gravelius_order_counts_from_the_trunk() {
    // A trunk 0-1-2, a lateral 3-4 from 1, and a lateral 5 from 3.
    let mut builder = Skeleton::builder(Vec3::ZERO, 1.0).unwrap();
    for (parent, radius) in [(0, 0.9), (1, 0.8), (1, 0.5), (3, 0.4), (3, 0.1)] {
        builder.add(parent, Vec3::new(radius, parent as f32, 0.0), radius).unwrap();
    }
    let skeleton = builder.finish();
    let axes = skeleton.axes(Continuation::Thickest);
    let orders: Vec<_> = (0..6).map(|node| axes.order_of(node).unwrap()).collect();
    assert_eq!(orders, [0, 0, 0, 1, 1, 2]);
    assert_eq!(axes.get(1).unwrap().nodes, [3, 4]);
    assert_eq!(axes.get(9), None);
}

#[cfg(feature = "serde")]
#[test]
fn an_invalid_skeleton_cannot_be_deserialized() {
    let text = serde_json::to_string(&fork()).unwrap();
    assert_eq!(serde_json::from_str::<Skeleton>(&text).unwrap(), fork());
    let broken = text.replace("\"parents\":[4294967295,0", "\"parents\":[4294967295,3");
    assert_ne!(broken, text);
    assert!(serde_json::from_str::<Skeleton>(&broken).is_err());
}

proptest! {
    #[test]
    fn every_node_is_one_child_and_on_one_axis(skeleton in any_skeleton(200)) {
        skeleton.check().unwrap();
        let children = skeleton.children();
        prop_assert_eq!(children.starts().len(), skeleton.len() + 1);
        for (node, ends) in children.starts().windows(2).enumerate() {
            let row = &children.nodes()[ends[0] as usize..ends[1] as usize];
            prop_assert_eq!(children.of(node as u32), row);
        }
        let mut listed: Vec<u32> =
            (0..skeleton.len() as u32).flat_map(|node| children.of(node).to_vec()).collect();
        listed.sort_unstable();
        prop_assert_eq!(listed, (1..skeleton.len() as u32).collect::<Vec<_>>());

        for rule in [Continuation::Thickest, Continuation::Longest, Continuation::Straightest] {
            let axes = skeleton.axes(rule);
            prop_assert_eq!(axes.starts().len(), axes.len() + 1);
            let mut on_axes = 0;
            for axis in axes.iter() {
                let ends = &axes.starts()[axis.index as usize..][..2];
                prop_assert_eq!(axis.nodes, &axes.nodes()[ends[0] as usize..ends[1] as usize]);
                on_axes += axis.nodes.len();
                for pair in axis.nodes.windows(2) {
                    prop_assert_eq!(skeleton.parent(pair[1]), Some(pair[0]));
                }
                let tip = axis.nodes[axis.nodes.len() - 1];
                prop_assert!(children.is_tip(tip));
                let below = skeleton.parent(axis.nodes[0]);
                prop_assert_eq!(
                    axis.order,
                    below.map_or(0, |node| axes.order_of(node).unwrap() + 1)
                );
            }
            prop_assert_eq!(on_axes, skeleton.len());
        }
    }

    #[test]
    fn shuffled_rows_give_back_the_same_tree(skeleton in any_skeleton(60), salt in 0_u64..1000) {
        let n = skeleton.len();
        let mut row_of: Vec<usize> = (0..n).collect();
        row_of.sort_by_key(|&node| crate::Seed(salt).child(node as u64));
        let mut node_at = vec![0; n];
        for (node, &row) in row_of.iter().enumerate() {
            node_at[row] = node;
        }
        let parents = node_at
            .iter()
            .map(|&node| skeleton.parent(node as u32).map_or(NO_PARENT, |p| row_of[p as usize] as u32))
            .collect();
        let positions = node_at.iter().map(|&node| skeleton.positions()[node]).collect();
        let radii = node_at.iter().map(|&node| skeleton.radii()[node]).collect();
        let again = Skeleton::from_unordered(positions, radii, parents).unwrap();
        again.skeleton.check().unwrap();
        for (node, &row) in again.rows.iter().enumerate() {
            let original = node_at[row as usize];
            prop_assert_eq!(again.skeleton.positions()[node], skeleton.positions()[original]);
            let parent = again.skeleton.parent(node as u32).map(|p| node_at[again.rows[p as usize] as usize]);
            prop_assert_eq!(parent, skeleton.parent(original as u32).map(|p| p as usize));
        }
    }
}
