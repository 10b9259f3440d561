use std::error::Error;
use tree_core::{Control, Seed};
use tree_model::sketch::template::*;
fn main() -> Result<(), Box<dyn Error>> {
    if std::env::args().any(|a| a == "dump") { return dump(); }
    let control = Control::default();
    let args: Vec<String> = std::env::args().skip(1).collect();
    let get = |n: &str, d: f32| args.iter().position(|a| a == n).map_or(d, |i| args[i + 1].parse().unwrap());
    let tp = TemplateParams { views: get("--views", 8.0) as u32, ..Default::default() };
    let tp = TemplateParams { main: MainBranches { gather: get("--gather", 0.015), most: get("--maxs", 40.0) as u32, least: get("--least", 0.3), least_second: get("--least2", 0.3), ..Default::default() }, ..tp };
    let sp = SelectParams { crown: get("--crown", 20.0), branches: get("--branches", 20.0), shape: get("--shape", 1.0), hand: get("--hand", 0.1), most: get("--most", 4.0) };
    let verbose = args.iter().any(|a| a == "-v");
    let mut templates = Vec::new();
    let mut trees = Vec::new();
    for e in EXEMPLARS {
        let tree = e.tree(Seed(1), &control)?;
        let t = Template::of_tree(e.name(), e.species(), &tree, &tp, &control)?;
        if verbose { 
            let b = main_branches(tree.skeleton(), &tp.main)?;
            let d = project(&b, 0.0, &[]);
            let o = b.orders(); let n = |k| o.iter().filter(|&&x| x == k).count();
            println!("{:14} strokes {} segments by order {} {} {} imagined {}", e.name(), d.strokes.len(), n(0), n(1), n(2), b.has_imagined_root());
            for h in &t.omega.orders { println!("     s {:.2}±{:.2} l {:.2}±{:.2} a {:.0}±{:.0} b {:.0}±{:.0} g {:.0}±{:.0}", h.scale.mean, h.scale.deviation, h.lateral_scale.mean, h.lateral_scale.deviation, h.alpha.mean.to_degrees(), h.alpha.deviation.to_degrees(), h.beta.mean.to_degrees(), h.beta.deviation.to_degrees(), h.gamma.mean.to_degrees(), h.gamma.deviation.to_degrees()); }
        }
        templates.push(t); trees.push(tree);
    }
    println!("text {} bytes", to_text(&templates).len());
    let again = parse(&to_text(&templates))?;
    assert_eq!(to_text(&again), to_text(&templates));
    let templates = again;
    for seeds in [vec![1u64], vec![2, 3]] {
    for with_crown in [true, false] {
        let (mut first, mut third, mut n) = (0, 0, 0);
        let mut margin: f32 = 1e9;
        for (k, e) in EXEMPLARS.iter().enumerate() {
            let mut line = String::new();
            for &seed in &seeds {
            let fresh; let tree = if seed == 1 { &trees[k] } else { fresh = e.tree(Seed(seed), &control)?; &fresh };
            let b = main_branches(tree.skeleton(), &tp.main)?;
            for v in 0..8 {
                let yaw = std::f32::consts::TAU * (v as f32 + 0.37) / 8.0;
                let crown = if with_crown { let c = crown_points(tree, yaw); if c.is_empty() { vec![] } else { c } } else { vec![] };
                let drawn = DrawnShape::of_branches(&b, yaw, &crown);
                let c = select(&drawn, &templates, &sp)?;
                let rank = c.iter().position(|c| c.template == k).unwrap();
                n += 1; first += usize::from(rank == 0); third += usize::from(rank < 3);
                if rank == 0 { margin = margin.min(c[0].score - c[1].score); }
                if rank > 0 { line += &format!(" {}:{}(#{})", v, templates[c[0].template].name, rank + 1); }
            }}
            if !line.is_empty() && (verbose || seeds.len() == 1) { println!("   {:14}{}", e.name(), line); }
        }
        println!("seeds {seeds:?} crown {with_crown}: first {:.1} % third {:.1} % of {n}, margin {margin:.2}", 100.0 * first as f32 / n as f32, 100.0 * third as f32 / n as f32);
    }}
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
        for s in &d.strokes { for p in &s.points { out += &format!("{} {} ", p.x, p.y); } out += "\n"; }
    }
    std::fs::write("/tmp/sketches.txt", out)?;
    Ok(())
}
