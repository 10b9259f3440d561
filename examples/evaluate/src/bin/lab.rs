use std::error::Error;
use std::time::Instant;
use tree_core::glam::Vec3;
use tree_core::{Control, Limits, Seed, Skeleton, Species, Tree};
use tree_lod::hybrid::{Hybrid, HybridParams};
use tree_lod::impostor::boxes::{Bearers, BoxParams, Boxes};
use tree_lod::impostor::cards::{CardParams, Cards};
use tree_lod::impostor::octahedral::{Octahedral, OctahedralParams};
use tree_lod::multires::{Metric, MultiMesh, Multires};
use tree_lod::preview::{self, Backdrop, Camera, Framing, Lens, Picture, Pose, Style, View, mask};
use tree_lod::quality::Score;
use tree_lod::{Elements, Foliage, Grain};
use tree_mesh::io::{self, ImportOptions};
use tree_mesh::{ErrorBound, Look, Mesh, MeshParams};
use tree_model::lsystem::LSystem;
type R<T = ()> = Result<T, Box<dyn Error>>;
const PAPER: &str = "
    steps: 12
    trunk_radius = 0.2
    leaf = 0.22
    axiom: A(1.6,0)
    A(l,n) : n < 10 -> F(l*nran(1,0.1))B(n)/(nran(90,15))[+(nran(24,6))A(l*0.82,n+1)][-(nran(30,6))A(l*0.82,n+1)]
    A(l,n) : n >= 10 -> F(l)B(n)
    B(n) : n == 0 || n == 2 -> [&(nran(50,12))~(leaf)]
    B(n) : n == 1 -> ε
    B(n) : n > 2 -> [&(nran(50,12))~(leaf)][^(nran(50,12))~(leaf)]
";
fn main() -> R {
    let a: Vec<String> = std::env::args().skip(1).collect();
    match a[0].as_str() {
        "time" => time(),
        "octa" => octa(&a[1..]),
        "tri" => tri(&a[1..]),
        "look" => look(&a[1..]),
        _ => Ok(()),
    }
}
fn time() -> R {
    let mut system = LSystem::parse(PAPER, &Limits::default())?;
    system.species = Species {
        name: "binary".into(),
        bark: "birch".into(),
        leaf_kinds: vec!["birch-cluster".into()],
    };
    let c = Control::default();
    let mut cases: Vec<(String, Tree)> = vec![("paper".into(), system.grow(Seed(1), &c)?.tree)];
    for name in ["oak", "birch", "spruce", "willow", "palm"] {
        let t = Instant::now();
        let tree = LSystem::preset(name)?.grow(Seed(1), &c)?.tree;
        println!("{name} grow {:?}", t.elapsed());
        cases.push((name.into(), tree));
    }
    for (name, tree) in cases {
        let mut look = Look::built_in(tree.species())?;
        look.bark.texture = None;
        let p =
            MeshParams { sides_max: 8, error: ErrorBound::Metres(0.01), ..MeshParams::default() };
        let t = Instant::now();
        let m = Multires::new(&tree, &Metric::default(), &c)?;
        let t1 = t.elapsed();
        let mm = MultiMesh::new(&m, &look, &p, &c)?;
        let t2 = t.elapsed();
        let mesh = mm.mesh();
        let f = Foliage::Surfaces((1..mesh.surfaces.len() as u32).collect());
        if tree.foliage().is_empty() {
            continue;
        }
        let e = Elements::of_mesh(mesh, &f, Grain::Leaf, &c)?;
        let t3 = t.elapsed();
        let b = Bearers::of_tree(m.tree(), mesh, &e)?;
        let bx = Boxes::along(
            m.tree().skeleton(),
            mesh,
            &e,
            &b,
            &BoxParams { most_boxes: 4, ..BoxParams::default() },
            &c,
        )?;
        let t4 = t.elapsed();
        let cp = CardParams { samples: 2, ..CardParams::default() };
        let mut best = f64::MAX;
        for _ in 0..5 {
            let t = Instant::now();
            Cards::bake(mesh, &e, &bx, &cp, &c)?;
            best = best.min(t.elapsed().as_secs_f64());
        }
        println!(
            "{name}: {} leaves {} tris; sort {t1:?} mesh {:?} elements {:?} boxes {:?} bake {:.1} ms ({} boxes)",
            tree.foliage().len(),
            mesh.n_triangles(),
            t2 - t1,
            t3 - t2,
            t4 - t3,
            1e3 * best,
            bx.boxes().len()
        );
    }
    Ok(())
}
fn imported(name: &str) -> R<Mesh> {
    let path = format!("/work/shared/data/meshes/{name}.glb");
    let mut mesh =
        io::read(std::path::Path::new(&path), &ImportOptions::default(), &Control::default())?.mesh;
    for s in &mut mesh.surfaces {
        s.positions.iter_mut().for_each(|p| *p *= 0.2);
    }
    Ok(mesh)
}
fn cameras(center: Vec3, radius: f32) -> impl Iterator<Item = Camera> {
    (0..32).map(move |i| {
        let share = (i as f32 + 0.5) / 32.0;
        let y = 0.9 * share;
        let (sin, cos) = (0.37 + 2.399_963 * i as f32).sin_cos();
        let level = (1.0 - y * y).sqrt();
        let direction = Vec3::new(level * cos, y, level * sin);
        let lens = Lens::Perspective { fov: 2.0 * (1.0f32 / 6.0).asin() };
        Camera::Placed(Pose {
            eye: center + 6.0 * radius * direction,
            target: center,
            up: Vec3::Y,
            lens,
        })
    })
}
fn octa(names: &[String]) -> R {
    let c = Control::default();
    for name in names {
        let mesh = if name.starts_with("ez") {
            imported(name)?
        } else {
            let tree = LSystem::preset(name)?.grow(Seed(2010), &c)?.tree;
            tree_mesh::build(&tree, &Look::built_in(tree.species())?, &MeshParams::default(), &c)?
                .mesh
        };
        let t = Instant::now();
        let baked = Octahedral::bake(&mesh, &OctahedralParams::default(), &c)?;
        let t = t.elapsed();
        let (mut q, mut p, mut r) = (0.0, 0.0, 0.0);
        let mut worst = 1.0_f64;
        for camera in cameras(baked.meta.center, baked.meta.radius) {
            let seen = baked.mask(&camera, 170, 170, &c)?;
            let view = View { width: 170, height: 170, samples: 3, camera };
            let full = mask(&mesh, &view, &c)?;
            let mut s = Score::default();
            for (a, b) in seen.bits().zip(full.bits()) {
                s.both += u64::from(a && b);
                s.wrong += u64::from(a && !b);
                s.missed += u64::from(!a && b);
            }
            q += s.quality() / 32.0;
            p += s.precision() / 32.0;
            r += s.recall() / 32.0;
            worst = worst.min(s.quality());
        }
        let png = baked.color.to_png()?.len() + baked.detail.to_png()?.len();
        println!(
            "{name}: Q {q:.4} P {p:.4} R {r:.4} worst {worst:.3} png {:.1} MB bake {t:?}",
            png as f64 / 1e6
        );
    }
    Ok(())
}
fn tri(names: &[String]) -> R {
    let c = Control::default();
    for name in names {
        let tree = LSystem::preset(name)?.grow(Seed(1), &c)?.tree;
        if tree.foliage().is_empty() {
            continue;
        }
        let look = Look::built_in(tree.species())?;
        let t = Instant::now();
        let h = Hybrid::make(&tree, &look, &HybridParams::default(), &c)?;
        let t = t.elapsed();
        let full = tree_mesh::build(&tree, &look, &MeshParams::default(), &c)?.mesh;
        let rep = h.cards().map(|k| k.boxes().report());
        println!(
            "{name}: full {} (wood {}), hybrid wood {} make {t:?} boxes {rep:?}",
            full.n_triangles(),
            full.surfaces[0].n_triangles(),
            h.mesh().surfaces[0].n_triangles()
        );
        for px in [1000.0, 500.0, 250.0, 100.0, 40.0, 20.0] {
            let ch = h.choice_for_height(px)?;
            let (b, l) = ch.leaves.as_ref().map_or((0, 0), |l| (l.boxes.len(), l.n_leaves()));
            println!(
                "  {px:>6}: level {:.0}/{} wood {} leaves {l} boxes {b} total {} plain {}",
                ch.level,
                h.wood().n_levels(),
                h.wood().wood_indices(ch.level) / 3,
                h.n_triangles(&ch),
                h.mesh_of(&ch)?.n_triangles()
            );
        }
    }
    Ok(())
}
/// mean luminance (over covered) and quality of hybrid against full, pictures
fn look(names: &[String]) -> R {
    let c = Control::default();
    let out = std::env::var("LAB_OUT").unwrap_or("/tmp/lab".into());
    std::fs::create_dir_all(&out)?;
    for name in names {
        let (full, at): (Mesh, Box<dyn Fn(f32) -> R<Mesh>>) = if name.starts_with("ez") {
            let mesh = imported(name)?;
            let elements = Elements::of_mesh(&mesh, &Foliage::Found, Grain::Leaf, &c)?;
            let mut trunk = Skeleton::builder(Vec3::ZERO, 0.1)?;
            trunk.add(0, Vec3::Y * mesh.bounds().max.y.max(0.1), 0.1)?;
            let trunk = trunk.finish();
            let bearers = Bearers(vec![1; elements.len()]);
            let boxes = Boxes::along(
                &trunk,
                &mesh,
                &elements,
                &bearers,
                &BoxParams { levels: 0, ..BoxParams::default() },
                &c,
            )?;
            let cards = Cards::bake(&mesh, &elements, &boxes, &CardParams::default(), &c)?;
            let whole = mesh.clone();
            (
                mesh,
                Box::new(move |px| {
                    let mut m = whole.clone();
                    if px > 200.0 {
                        return Ok(m);
                    }
                    for (i, s) in m.surfaces.iter_mut().enumerate() {
                        if elements.surfaces.contains(&(i as u32)) {
                            *s = tree_mesh::Surface { material: s.material, ..Default::default() };
                        }
                    }
                    m.surfaces.retain(|s| !s.positions.is_empty());
                    let plain = cards.plain(&[0])?;
                    let first = m.materials.len() as u32;
                    m.materials.extend(plain.materials);
                    for mut s in plain.surfaces {
                        s.material += first;
                        m.surfaces.push(s);
                    }
                    Ok(m)
                }),
            )
        } else {
            let tree = if let Some(n) = name.strip_prefix("path-") {
                tree_model::path::Preset::find(n)?.params()?.grow(Seed(1), &c)?.tree
            } else {
                LSystem::preset(name)?.grow(Seed(1), &c)?.tree
            };
            let look = Look::built_in(tree.species())?;
            let h = Hybrid::make(&tree, &look, &HybridParams::default(), &c)?;
            let full = tree_mesh::build(&tree, &look, &MeshParams::default(), &c)?.mesh;
            (full, Box::new(move |px| Ok(h.mesh_of(&h.choice_for_height(px)?)?)))
        };
        let mut sheet: Vec<[Picture; 2]> = Vec::new();
        for px in std::env::var("LAB_PX")
            .unwrap_or("250,100,40".into())
            .split(',')
            .map(|v| v.parse::<f32>().unwrap())
        {
            let ours = at(px)?;
            let (mut q, mut cov, mut lum, mut diff, mut n) = (0.0, 0.0, [0.0_f64; 6], 0.0, 0.0);
            for yaw in 0..2 {
                for pitch in [0.05] {
                    let camera = Camera::Framed(Framing {
                        yaw: 0.3 + 1.9 * yaw as f32,
                        pitch,
                        ..Framing::default()
                    });
                    let camera = Camera::Placed(camera.pose(&full, 1.0)?);
                    let side = px.min(250.0) as u32;
                    let view = View { width: side, height: side, samples: 3, camera };
                    let style =
                        Style { ground: None, backdrop: Backdrop::Studio, ..Style::default() };
                    let (pa, pb) = (
                        preview::render(&full, &view, &style, &c)?,
                        preview::render(&ours, &view, &style, &c)?,
                    );
                    let (ma, mb) = (mask(&full, &view, &c)?, mask(&ours, &view, &c)?);
                    let mut s = Score::default();
                    for (a, b) in mb.bits().zip(ma.bits()) {
                        s.both += u64::from(a && b);
                        s.wrong += u64::from(a && !b);
                        s.missed += u64::from(!a && b);
                    }
                    q += s.quality();
                    cov += mb.area() / ma.area();
                    n += 1.0;
                    let mean = |p: &Picture, m: &preview::Mask| {
                        let mut sum = [0.0_f64; 4];
                        for (t, &k) in p.pixels.chunks_exact(4).zip(&m.coverage) {
                            if k > 200 {
                                sum[3] += 1.0;
                                for i in 0..3 {
                                    sum[i] += f64::from(t[i]);
                                }
                            }
                        }
                        [0, 1, 2].map(|i| sum[i] / sum[3].max(1.0))
                    };
                    let (x, y) = (mean(&pa, &ma), mean(&pb, &mb));
                    for i in 0..3 {
                        lum[i] += x[i];
                        lum[3 + i] += y[i];
                    }
                    diff += pa
                        .pixels
                        .iter()
                        .zip(&pb.pixels)
                        .map(|(a, b)| f64::from(a.abs_diff(*b)))
                        .sum::<f64>()
                        / pa.pixels.len() as f64;
                    if yaw == 0 {
                        let big = |p: &Picture| {
                            let mut s = Picture { width: 400, height: 400, pixels: Vec::new() };
                            for j in 0..400 {
                                for i in 0..400 {
                                    s.pixels
                                        .extend(p.pixel(i * side / 400, j * side / 400).unwrap());
                                }
                            }
                            s
                        };
                        sheet.push([big(&pa), big(&pb)]);
                    }
                }
            }
            println!(
                "{name} {px:>5}: Q {:.3} coverage {:.3} colour full {:.0?} ours {:.0?} diff {:.2} tris {} of {}",
                q / n,
                cov / n,
                [0, 1, 2].map(|i| lum[i] / n),
                [3, 4, 5].map(|i| lum[i] / n),
                diff / n,
                ours.n_triangles(),
                full.n_triangles()
            );
        }
        let (w, h) = (400 * sheet.len() as u32, 800);
        let mut pixels = Vec::new();
        for row in 0..h {
            for pair in &sheet {
                let p = &pair[(row / 400) as usize];
                let s = (row % 400 * 400 * 4) as usize;
                pixels.extend_from_slice(&p.pixels[s..s + 1600]);
            }
        }
        Picture { width: w, height: h, pixels }.save_png(format!("{out}/{name}.png"))?;
    }
    Ok(())
}
