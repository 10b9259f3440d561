use super::*;
use crate::impostor::cards::CardParams;
use crate::impostor::tests::{Forked, forked};
use tree_core::Control;

fn ready() -> (Cards, Choice) {
    let Forked { mesh, elements, boxes, .. } = forked(400);
    let params = CardParams { size: 32, samples: 1, gutter: 1 };
    let cards = Cards::bake(&mesh, &elements, &boxes, &params, &Control::default()).unwrap();
    let choice = Choice::new(&cards).unwrap();
    (cards, choice)
}

fn at(distance: f32) -> Watcher {
    Watcher { eye: Vec3::new(distance, 3.0, 0.0), pixels_per_metre: 800.0 }
}

/// How often each leaf is drawn.
fn drawn(boxes: &Boxes, choice: &Choice) -> Vec<u32> {
    let mut times = vec![0; boxes.order().len()];
    let of_boxes = choice.boxes.iter().map(|&b| boxes.boxes()[b as usize].leaves.clone());
    for rows in of_boxes.chain(choice.leaves.iter().cloned()) {
        boxes.leaves(rows).iter().for_each(|&leaf| times[leaf as usize] += 1);
    }
    times
}

#[test]
fn every_leaf_is_drawn_once_at_any_distance() {
    let (cards, mut choice) = ready();
    let boxes = cards.boxes();
    assert!(boxes.boxes().len() > 3, "{:?}", boxes.report());
    let mut kinds = [false; 3];
    for i in 0..60 {
        let distance = 0.5 * libm::powf(1.15, i as f32);
        choice.update(boxes, &at(distance), &ChooseParams::default()).unwrap();
        assert!(drawn(boxes, &choice).iter().all(|&times| times == 1), "{distance}");
        assert!(choice.leaves.windows(2).all(|pair| pair[0].end < pair[1].start));
        kinds[0] |= choice.boxes == [0];
        kinds[1] |= choice.boxes.len() > 1;
        kinds[2] |= choice.boxes.is_empty();
    }
    assert_eq!(kinds, [true; 3], "one box from afar, several nearer, only leaves close by");
}

#[test]
fn further_away_fewer_leaves_are_geometry() {
    let (cards, mut choice) = ready();
    let mut last = usize::MAX;
    for distance in [1.0, 5.0, 20.0, 80.0, 320.0, 1280.0] {
        choice.update(cards.boxes(), &at(distance), &ChooseParams::default()).unwrap();
        assert!(choice.n_leaves() <= last);
        last = choice.n_leaves();
    }
    assert_eq!(last, 0);
}

#[test]
fn a_trembling_camera_does_not_switch() {
    let (cards, mut choice) = ready();
    let params = ChooseParams::default();
    // Where the whole tree just opens.
    let threshold = (1..4000).map(|i| 0.5 * i as f32).find(|&distance| {
        let mut fresh = Choice::new(&cards).unwrap();
        fresh.update(cards.boxes(), &at(distance), &params).unwrap();
        fresh.boxes == [0]
    });
    let threshold = threshold.unwrap();
    choice.update(cards.boxes(), &at(0.98 * threshold), &params).unwrap();
    let open = choice.boxes.clone();
    assert_ne!(open, [0]);
    choice.update(cards.boxes(), &at(1.02 * threshold), &params).unwrap();
    assert_ne!(choice.boxes, [0], "it is still open");
    choice.update(cards.boxes(), &at(1.3 * threshold), &params).unwrap();
    assert_eq!(choice.boxes, [0]);
}

#[test]
fn choosing_keeps_to_the_room_it_has() {
    let (cards, mut choice) = ready();
    let room = |c: &Choice| (c.boxes.capacity(), c.leaves.capacity(), c.stack.capacity());
    let before = room(&choice);
    for distance in [0.1, 3.0, 10.0, 30.0, 100.0, 1e4] {
        choice.update(cards.boxes(), &at(distance), &ChooseParams::default()).unwrap();
    }
    assert_eq!(room(&choice), before);
}

#[test]
fn a_watcher_who_is_nowhere_is_refused() {
    let (cards, mut choice) = ready();
    let params = ChooseParams::default();
    let nowhere = Watcher { eye: Vec3::NAN, ..at(1.0) };
    let blind = Watcher { pixels_per_metre: 0.0, ..at(1.0) };
    for watcher in [nowhere, blind, Watcher { pixels_per_metre: f32::NAN, ..blind }] {
        let found = choice.update(cards.boxes(), &watcher, &params);
        assert!(matches!(found, Err(LodError::Parameter(_))));
    }
    let odd = ChooseParams { hysteresis: 2.0, ..params };
    assert!(choice.update(cards.boxes(), &at(1.0), &odd).is_err());
    let mut empty = Choice::default();
    let found = empty.update(cards.boxes(), &at(1.0), &params);
    assert!(matches!(found, Err(LodError::Length { .. })));
}
