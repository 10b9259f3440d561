use tree_core::{Control, Seed};
use tree_model::sketch::clean::*;
use tree_model::sketch::infer::*;
use tree_model::sketch::template::*;
use tree_model::sketch::*;
fn main() {
    let control = Control::default();
    let only = std::env::args().nth(1);
    for e in &EXEMPLARS {
        if only.as_deref().is_some_and(|o| o != e.name()) {
            continue;
        }
        let tree = e.tree(SEED, &control).unwrap();
        let b = main_branches(tree.skeleton(), &MainBranches::default()).unwrap();
        let t = Template::find(e.name()).unwrap();
        let mut line = format!("{:14} {} orders {} |", e.name(), b.len(), t.omega.orders.len());
        for v in 0..4 {
            let d = project(&b, 0.19 + v as f32 * 0.785, &[]);
            let c =
                clean(&d, &CleanParams { merge: 0.0, snap: 0.004, ..Default::default() }, &control)
                    .unwrap();
            let inf = infer(
                &c.plan,
                &t.omega,
                &InferParams { rounds: 0, ..Default::default() },
                Seed(1),
                &control,
            )
            .unwrap();
            let mut kinds = std::collections::BTreeMap::new();
            for r in &c.report.repairs {
                *kinds
                    .entry(format!("{:?}", r.kind).split('(').next().unwrap().to_string())
                    .or_insert(0) += 1;
            }
            line += &format!(
                " strokes {} -> segs {} {:?};",
                d.strokes.len(),
                inf.branches.len(),
                kinds
            );
        }
        println!("{line}");
        if only.is_some() {
            println!("{:#?}", t.omega);
            for r in b.relations() {
                println!("{r:?}");
            }
        }
    }
}
