//! throw-away
use std::error::Error;
use tree_core::glam::{Vec2, Vec3};
use tree_core::{Control, Limits, Seed, file};
use tree_lod::preview::{self, Camera, Lens, Pose, View};
use tree_mesh::{LeafForm, LeafMesh, Look, MeshParams};
use tree_model::particle::Photo;
use tree_model::silhouette::Outline;
use tree_model::silhouette::place::revolve::{Section, Surface};
use tree_model::silhouette::read;
use tree_model::silhouette::session::{Session, SilhouetteParams};
const N: usize = 64;
fn main() -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let mut names: Vec<std::path::PathBuf> = std::env::args().skip(1).map(Into::into).collect();
    if names.is_empty() {
        for d in ["examples/outlines", "../shared/data/silhouettes"] {
            let mut v: Vec<_> = std::fs::read_dir(d)?
                .map(|e| e.unwrap().path())
                .filter(|p| p.extension().is_some_and(|e| e == "svg" || e == "png"))
                .collect();
            v.sort();
            names.extend(v);
        }
    }
    let out = std::path::Path::new("/tmp/fit");
    std::fs::create_dir_all(out)?;
    let (mut sf, mut ss, mut n) = (0.0, 0.0, 0);
    for path in names {
        let drawing = if path.extension().unwrap() == "svg" {
            read::from_svg(&file::read_text(&path, &Limits::default())?)
        } else {
            read::from_photo(&Photo::open(&path, &Limits::default())?)
        };
        let drawing = match drawing {
            Ok(d) => d,
            Err(e) => {
                println!("{path:?}: {e}");
                continue;
            }
        };
        let t0 = std::time::Instant::now();
        let (session, _) =
            match Session::of_drawing(&drawing.trees[0], SilhouetteParams::default(), Seed(1)) {
                Ok(s) => s,
                Err(e) => {
                    println!("{path:?}: {e}");
                    continue;
                }
            };
        let t1 = t0.elapsed();
        let plan = session.plan().unwrap();
        let t2 = std::time::Instant::now();
        let grown = session.tree(&control)?;
        let t3 = t2.elapsed();
        let mut look = Look::built_in(grown.tree.species())?;
        if let Some(leaf) = &plan.leaf {
            look.leaves = Look::plain(grown.tree.species()).leaves;
            for k in &mut look.leaves {
                k.form = LeafForm::Mesh(std::sync::Arc::new(LeafMesh::flat(
                    &leaf.outline.points,
                    &leaf.outline.triangles,
                )));
            }
        }
        let mesh = tree_mesh::build(&grown.tree, &look, &MeshParams::default(), &control)?.mesh;
        let mut line = String::new();
        let mut fits = [0.0; 2];
        for side in 0..2 {
            let outline: Outline = if side == 0 {
                plan.system.outline.clone()
            } else {
                let mut sections = vec![Section { azimuth: 0.0, outline: &plan.system.outline }];
                sections.extend(
                    plan.system
                        .sections
                        .iter()
                        .map(|s| Section { azimuth: s.azimuth, outline: &s.outline }),
                );
                let s = Surface::of(&plan.system.axis, &sections);
                let p = s.profile(std::f32::consts::FRAC_PI_2).unwrap();
                p
            };
            let (low, high) = outline.bounds();
            let size = (high - low).max_element() * 1.1;
            let c = 0.5 * (low + high);
            // seen from -X for azimuth 90: right is +Z
            let (target, away) = if side == 0 {
                (Vec3::new(c.x, c.y, 0.0), Vec3::Z)
            } else {
                (Vec3::new(0.0, c.y, c.x), Vec3::NEG_X)
            };
            let pose = Pose {
                eye: target + 10.0 * size * away,
                target,
                up: Vec3::Y,
                lens: Lens::Orthographic { height: size },
            };
            let mask = |px: u32| {
                preview::mask(
                    &mesh,
                    &View { width: px, height: px, samples: 4, camera: Camera::Placed(pose) },
                    &control,
                )
            };
            let m = mask(N as u32)?;
            let want = |px: usize| outline.mask(c - 0.5 * size, c + 0.5 * size, px, px);
            let iou = |bits: Vec<bool>, want: Vec<bool>, px: usize| {
                let (mut i, mut u) = (0, 0);
                for y in 0..px {
                    for x in 0..px {
                        let a = bits[y * px + x];
                        let b = want[(px - 1 - y) * px + x];
                        // trunk below the crown
                        let py = c.y - 0.5 * size + (px - y) as f32 / px as f32 * size;
                        if a && !b && py < low.y {
                            continue;
                        }
                        let pp =
                            Vec2::new(c.x - 0.5 * size + (x as f32 + 0.5) / px as f32 * size, py);
                        if a && !b && side == 0 && plan.system.axis.nearest(pp).1 < 0.03 * size {
                            continue;
                        }
                        i += usize::from(a && b);
                        u += usize::from(a || b);
                    }
                }
                i as f64 / u as f64
            };
            fits[side] = iou(m.bits().collect(), want(N), N);
            if side == 0 {
                let px = 360usize;
                let m = mask(px as u32)?;
                let w = want(px);
                let mut img = image::RgbImage::new(px as u32, px as u32);
                for (i, b) in m.bits().enumerate() {
                    let (x, y) = (i % px, i / px);
                    let o = w[(px - 1 - y) * px + x];
                    img.put_pixel(
                        x as u32,
                        y as u32,
                        image::Rgb(match (b, o) {
                            (true, true) => [60, 140, 60],
                            (true, false) => [220, 40, 40],
                            (false, true) => [240, 200, 60],
                            _ => [255; 3],
                        }),
                    );
                }
                img.save(out.join(format!("{}.png", path.file_stem().unwrap().to_string_lossy())))?;
            }
        }
        line += &format!(
            "{:<22} front {:.3} side {:.3}  plan {:>6.1} ms grow {:>6.1} ms  {:?} {} leaves noroom {} cov {:.2} {:.2}",
            path.file_stem().unwrap().to_string_lossy(),
            fits[0],
            fits[1],
            t1.as_secs_f64() * 1e3,
            t3.as_secs_f64() * 1e3,
            grown.report.branches,
            grown.report.leaves,
            grown.report.without_room,
            session.coverage().by_bumps,
            session.coverage().by_all
        );
        println!("{line}");
        sf += fits[0];
        ss += fits[1];
        n += 1;
    }
    println!("mean {:.3} {:.3}", sf / n as f64, ss / n as f64);
    Ok(())
}
