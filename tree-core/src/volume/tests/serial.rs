use super::*;

proptest! {
    #[test]
    fn a_volume_survives_writing_and_reading(volume in any_volume()) {
        let text = serde_json::to_string(&volume).unwrap();
        let read: Volume = serde_json::from_str(&text).unwrap();
        prop_assert_eq!(read, volume);
    }
}

#[test]
fn an_invalid_volume_cannot_be_read() {
    let read = |text: &str| serde_json::from_str::<Volume>(text).map_err(|e| e.to_string());
    assert!(read(r#"{"Sphere":{"center":[0,0,0],"radius":1}}"#).is_ok());
    let error = read(r#"{"Sphere":{"center":[0,0,0],"radius":-1}}"#).unwrap_err();
    assert!(error.contains("sphere.radius"), "{error}");
    assert!(read(r#"{"Union":[]}"#).is_err());
    assert!(read(r#"{"Union":[{"Sphere":{"center":[0,0,0],"radius":0}}]}"#).is_err());
}

fn nested(depth: usize) -> String {
    let leaf = r#"{"Sphere":{"center":[0,0,0],"radius":1}}"#;
    format!(r#"{}{leaf}{}"#, r#"{"Union":["#.repeat(depth), "]}".repeat(depth))
}

#[test]
fn the_deepest_volume_can_be_read_and_a_deeper_one_is_refused() {
    let read = |depth| serde_json::from_str::<Volume>(&nested(depth));
    let deepest = read(MAX_DEPTH as usize).unwrap();
    assert!(deepest.contains(Vec3::ZERO));
    for depth in [MAX_DEPTH as usize + 1, 60] {
        let error = read(depth).unwrap_err().to_string();
        assert!(error.contains("volume.depth"), "{error}");
        // The count starts anew after an error.
        assert!(read(MAX_DEPTH as usize).is_ok());
    }
}
