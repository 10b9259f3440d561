//! Cost of one inside test, the inner loop of rejection sampling; meshes sweep their size.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tree_core::glam::{Vec2, Vec3};
use tree_core::{Seed, Volume, seed};

/// Points per measurement, uniform in the box of the volume.
const N_POINTS: usize = 1024;

/// A latitude-longitude sphere of `2 * n_lon * (n_lat - 1)` triangles.
fn globe(n_lat: u32, n_lon: u32) -> tree_core::error::Result<Volume> {
    let mut positions = Vec::new();
    for lat in 0..=n_lat {
        let theta = std::f32::consts::PI * lat as f32 / n_lat as f32;
        for lon in 0..n_lon {
            let phi = std::f32::consts::TAU * lon as f32 / n_lon as f32;
            let pole = lat == 0 || lat == n_lat;
            let ring = if pole { 0.0 } else { libm::sinf(theta) };
            positions.push(Vec3::new(
                ring * libm::cosf(phi),
                libm::cosf(theta),
                ring * libm::sinf(phi),
            ));
        }
    }
    let mut triangles = Vec::new();
    for lat in 0..n_lat {
        for lon in 0..n_lon {
            let next = (lon + 1) % n_lon;
            let [a, b] = [lat * n_lon + lon, lat * n_lon + next];
            let [c, d] = [a + n_lon, b + n_lon];
            if lat > 0 {
                triangles.push([a, b, c]);
            }
            if lat + 1 < n_lat {
                triangles.push([b, d, c]);
            }
        }
    }
    Volume::mesh(positions, triangles)
}

fn volumes() -> tree_core::error::Result<Vec<(String, Volume)>> {
    let sphere = Volume::sphere(Vec3::ZERO, 1.0)?;
    let crown: Vec<Vec2> = (0..=32)
        .map(|i| {
            let t = i as f32 / 32.0;
            Vec2::new(3.0 * (t * (1.0 - t)).sqrt(), 4.0 * t)
        })
        .collect();
    let three = sphere
        .union(&Volume::ellipsoid(Vec3::X, Vec3::new(1.0, 2.0, 1.0))?)?
        .union(&Volume::capsule(-Vec3::X, Vec3::Y, 0.5)?)?;
    let mut volumes = vec![
        ("sphere".to_string(), sphere),
        ("cone".to_string(), Volume::cone(Vec3::ZERO, Vec3::Y, 0.5)?),
        ("sector".to_string(), Volume::sector(Vec3::ZERO, Vec3::Y, 0.8, 2.0)?),
        ("union of 3".to_string(), three),
        ("revolution of 32".to_string(), Volume::revolution(Vec3::ZERO, Vec3::Y, crown)?),
    ];
    for n_lat in [5, 16, 36, 160] {
        let n_triangles = 4 * n_lat * (n_lat - 1);
        volumes.push((format!("mesh of {n_triangles}"), globe(n_lat, 2 * n_lat)?));
    }
    Ok(volumes)
}

fn contains(c: &mut Criterion) {
    let Ok(volumes) = volumes() else {
        return;
    };
    let mut group = c.benchmark_group("contains");
    group.throughput(criterion::Throughput::Elements(N_POINTS as u64));
    for (name, volume) in &volumes {
        let bounds = volume.bounds();
        let mut rng = Seed(1).rng();
        let points: Vec<Vec3> = (0..N_POINTS)
            .map(|_| {
                let mut along =
                    |axis: usize| seed::uniform(&mut rng, bounds.min[axis], bounds.max[axis]);
                Vec3::new(along(0), along(1), along(2))
            })
            .collect();
        group.bench_with_input(BenchmarkId::from_parameter(name), &points, |b, points| {
            b.iter(|| points.iter().filter(|&&p| black_box(volume).contains(p)).count());
        });
    }
    group.finish();
}

fn distance(c: &mut Criterion) {
    let Ok(volumes) = volumes() else {
        return;
    };
    let mut group = c.benchmark_group("distance");
    for (name, volume) in &volumes {
        let p = volume.bounds().center() + Vec3::new(0.3, 0.2, 0.1);
        group.bench_function(BenchmarkId::from_parameter(name), |b| {
            b.iter(|| black_box(volume).distance(black_box(p)));
        });
    }
    group.finish();
}

criterion_group!(benches, contains, distance);
criterion_main!(benches);
