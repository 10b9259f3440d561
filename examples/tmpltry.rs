use std::error::Error;
use tree_core::{Control, Seed};
use tree_model::sketch::template::*;
fn main() -> Result<(), Box<dyn Error>> {
    if std::env::args().any(|a| a == "dump") {
        return dump();
    }
    let control = Control::default();
    let args: Vec<String> = std::env::args().skip(1).collect();
    let get = |n: &str, d: f32| {
        args.iter().position(|a| a == n).map_or(d, |i| args[i + 1].parse().unwrap())
    };
    let tp = TemplateParams { views: get("--views", 8.0) as u32, ..Default::default() };
    let tp = TemplateParams {
        main: MainBranches { gather: get("--gather", 0.025), ..Default::default() },
        ..tp
    };
    let sp = SelectParams {
        crown: get("--crown", 40.0),
        branches: get("--branches", 40.0),
        shape: get("--shape", 1.0),
        directions: get("--dir", 10.0),
        hand: get("--hand", 0.3),
        most: get("--most", 2.0),
    };
    let verbose = args.iter().any(|a| a == "-v");
    let mut templates = Vec::new();
    let mut trees = Vec::new();
    for e in EXEMPLARS {
        let tree = e.tree(Seed(1), &control)?;
        let t = Template::of_tree(e.name(), e.species(), &tree, &tp, &control)?;
        if verbose {
            let b = main_branches(tree.skeleton(), &tp.main)?;
            let d = project(&b, 0.0, &[]);
            let o = b.orders();
            let n = |k| o.iter().filter(|&&x| x == k).count();
            println!(
                "{:14} strokes {} segments by order {} {} {} imagined {}",
                e.name(),
                d.strokes.len(),
                n(0),
                n(1),
                n(2),
                b.has_imagined_root()
            );
            for h in &t.omega.orders {
                println!(
                    "     s {:.2}±{:.2} l {:.2}±{:.2} a {:.0}±{:.0} b {:.0}±{:.0} g {:.0}±{:.0}",
                    h.scale.mean,
                    h.scale.deviation,
                    h.lateral_scale.mean,
                    h.lateral_scale.deviation,
                    h.alpha.mean.to_degrees(),
                    h.alpha.deviation.to_degrees(),
                    h.beta.mean.to_degrees(),
                    h.beta.deviation.to_degrees(),
                    h.gamma.mean.to_degrees(),
                    h.gamma.deviation.to_degrees()
                );
            }
        }
        templates.push(t);
        trees.push(tree);
    }
    println!("text {} bytes", to_text(&templates).len());
    let again = parse(&to_text(&templates))?;
    assert_eq!(to_text(&again), to_text(&templates));
    let templates = again;
    // (name, seeds, most strokes, drawn with crown)
    let grids: Vec<[f32; 6]> = if args.iter().any(|a| a == "grid") {
        let mut g = vec![];
        for c in [40.0] {
            for b in [20.0, 40.0] {
                for m in [1.0] {
                    for h in [0.3] {
                        for d in [0.0, 5.0, 10.0, 20.0, 40.0] {
                            g.push([c, b, 1.0, h, m, d]);
                        }
                    }
                }
            }
        }
        g
    } else {
        vec![[sp.crown, sp.branches, sp.shape, sp.hand, sp.most, sp.directions]]
    };
    let mut cases = vec![];
    for (name, seeds, most) in
        [("same", vec![1u64], 36), ("same12", vec![1], 12), ("other", vec![2, 3], 36)]
    {
        let mut list = vec![];
        for (k, e) in EXEMPLARS.iter().enumerate() {
            for &seed in &seeds {
                let fresh;
                let tree = if seed == 1 {
                    &trees[k]
                } else {
                    fresh = e.tree(Seed(seed), &control)?;
                    &fresh
                };
                let b = main_branches(tree.skeleton(), &MainBranches { most, ..tp.main.clone() })?;
                for v in 0..8 {
                    let yaw = std::f32::consts::TAU * (v as f32 + 0.37) / 8.0;
                    for with in [true, false] {
                        let crown = if with { crown_points(tree, yaw) } else { vec![] };
                        if args.iter().any(|a| a == "clean") {
                            let lines = if with && !crown.is_empty() {
                                vec![tree_model::sketch::convex_hull(&crown)]
                            } else {
                                vec![]
                            };
                            let mut d = project(&b, yaw, &lines);
                            if args.iter().any(|a| a == "norole") {
                                for s in &mut d.strokes {
                                    s.role = None;
                                }
                            }
                            let cleaned = tree_model::sketch::clean::clean(
                                &d,
                                &Default::default(),
                                &control,
                            )?;
                            let crown: Vec<_> = cleaned.crown.concat();
                            list.push((k, v, with, DrawnShape::measure(&cleaned.plan, &crown)));
                            continue;
                        }
                        list.push((k, v, with, DrawnShape::of_branches(&b, yaw, &crown)));
                    }
                }
            }
        }
        cases.push((name, list));
    }
    for g in grids {
        let sp = SelectParams {
            crown: g[0],
            branches: g[1],
            shape: g[2],
            hand: g[3],
            most: g[4],
            directions: g[5],
        };
        let mut line = format!("{g:?}");
        for (name, list) in &cases {
            let mut c = [[0.0f32; 3]; 2];
            let mut margin = 1e9f32;
            let mut wrong = String::new();
            for (k, v, with, d) in list {
                let r = select(d, &templates, &sp)?;
                let rank = r.iter().position(|c| c.template == *k).unwrap();
                let c = &mut c[usize::from(!with)];
                c[0] += 1.0;
                c[1] += f32::from(rank == 0);
                c[2] += f32::from(rank < 3);
                if args.iter().any(|a| a == "why") && !with && rank > 0 {
                    println!(
                        "{} v{v} drawn {:?}\n  own {:?}\n  own choice {:?}\n won {:?} by {} shape {:?}",
                        EXEMPLARS[*k].name(),
                        d.shape,
                        templates[*k].views[0].shape,
                        r[rank],
                        r[0],
                        templates[r[0].template].name,
                        templates[r[0].template].views[0].shape
                    );
                }
                if rank == 0 {
                    margin = margin.min(r[0].score - r[1].score);
                } else {
                    wrong += &format!(
                        " {}{}>{}",
                        EXEMPLARS[*k].name(),
                        if *with { "+" } else { "-" },
                        templates[r[0].template].name
                    );
                    let _ = v;
                }
            }
            line += &format!(
                " | {name} {:.0}/{:.0} {:.0}/{:.0} m{margin:.2}",
                100.0 * c[0][1] / c[0][0],
                100.0 * c[0][2] / c[0][0],
                100.0 * c[1][1] / c[1][0],
                100.0 * c[1][2] / c[1][0]
            );
            if verbose {
                println!("{name}: {wrong}");
            }
        }
        println!("{line}");
    }
    Ok(())
}
#[allow(dead_code)]
pub fn dump() -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let tp = TemplateParams::default();
    let mut out = String::new();
    for e in EXEMPLARS {
        let tree = e.tree(Seed(1), &control)?;
        let b = main_branches(tree.skeleton(), &tp.main)?;
        let d = project(&b, 0.3, &[]);
        out += &format!("# {}\n", e.name());
        for s in &d.strokes {
            for p in &s.points {
                out += &format!("{} {} ", p.x, p.y);
            }
            out += "\n";
        }
    }
    std::fs::write("/tmp/sketches.txt", out)?;
    Ok(())
}
