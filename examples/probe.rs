//! Throw-away: synthetic round trip.
use glam::{DVec2, DVec3, Vec2};
use tree_core::{Control, NO_PARENT, Seed, seed};
use tree_model::sketch::infer::*;
use tree_model::sketch::*;

struct T {
    v: Vec<DVec3>,
    end: Vec<DVec3>,
    parent: Vec<u32>,
    label: Vec<Label>,
    order: Vec<u32>,
}

fn across(v: DVec3, a: DVec3) -> DVec3 {
    (v - a * v.dot(a)).normalize()
}

fn grow(omega: &Omega, n: usize, s: Seed) -> T {
    let mut rng = s.stream("synthetic").rng();
    let mut t = T {
        v: vec![DVec3::Y * 2.0],
        end: vec![DVec3::Y * 2.0],
        parent: vec![NO_PARENT],
        label: vec![Label::Apical],
        order: vec![0],
    };
    let mut side = vec![DVec3::X];
    let mut i = 0;
    while t.v.len() < n {
        let h = omega.habit(t.order[i]);
        let mut g = |n: Normal| {
            f64::from(n.mean)
                + f64::from(n.deviation) * f64::from(seed::normal(&mut rng)).clamp(-2.5, 2.5)
        };
        let axis = t.v[i].normalize();
        let l = t.v[i].length();
        let turn = glam::DQuat::from_axis_angle(axis, g(h.gamma));
        let sd = turn * across(side[i], axis);
        let b = g(h.beta).abs();
        let lat = (axis * b.cos() + sd * b.sin()) * l * g(h.lateral_scale).exp();
        let a = g(h.alpha).abs();
        let phi = 2.0 * g(Normal::new(0.0, 3.0));
        let ad = glam::DQuat::from_axis_angle(axis, phi) * sd;
        let ap = (axis * a.cos() + ad * a.sin()) * l * g(h.scale).exp();
        for (v, lab) in [(ap, Label::Apical), (lat, Label::Lateral(0))] {
            t.v.push(v);
            t.end.push(t.end[i] + v);
            t.parent.push(i as u32);
            t.label.push(lab);
            t.order.push(t.order[i] + u32::from(lab != Label::Apical));
            side.push(if lab == Label::Apical {
                across(sd, v.normalize())
            } else {
                across(axis, v.normalize())
            });
        }
        i += 1;
    }
    t
}

fn plan(t: &T, yaw: f64) -> Plan {
    let rot = glam::DQuat::from_rotation_y(yaw);
    let p = |v: DVec3| {
        let q = rot * v;
        Vec2::new(q.x as f32, q.y as f32)
    };
    let mut pos = vec![Vec2::ZERO];
    let mut par = vec![NO_PARENT];
    let mut str_ = vec![0u32];
    let mut node = vec![0u32; t.v.len()];
    let mut stroke = vec![0u32; t.v.len()];
    let mut ns = 1;
    for i in 0..t.v.len() {
        let (start, pn) = if i == 0 {
            (DVec3::ZERO, 0)
        } else {
            (t.end[t.parent[i] as usize], node[t.parent[i] as usize])
        };
        stroke[i] = if i == 0 {
            0
        } else if t.label[i] == Label::Apical {
            stroke[t.parent[i] as usize]
        } else {
            ns += 1;
            ns - 1
        };
        let mut last = pn;
        for k in 1..=4 {
            pos.push(p(start + t.v[i] * (k as f64 / 4.0)));
            par.push(last);
            str_.push(stroke[i]);
            last = pos.len() as u32 - 1;
        }
        node[i] = last;
    }
    Plan::from_columns(pos, par, str_, Vec2::ZERO, 1.0).unwrap()
}

fn ks(a: &mut Vec<f64>, b: &mut Vec<f64>) -> f64 {
    a.sort_by(f64::total_cmp);
    b.sort_by(f64::total_cmp);
    let f = |v: &Vec<f64>, x: f64| v.partition_point(|&y| y <= x) as f64 / v.len() as f64;
    a.iter().chain(b.iter()).map(|&x| (f(a, x) - f(b, x)).abs()).fold(0.0, f64::max)
}
fn med(v: &[f64]) -> f64 {
    let mut v = v.to_vec();
    v.sort_by(f64::total_cmp);
    v[v.len() / 2]
}

fn local(
    g: &FactorGraph,
    omega: &Omega,
    labels: &[Label],
    mut z: Vec<f64>,
    tol: f64,
) -> (f64, Vec<f64>) {
    let mut best = g.posterior(omega, &z, labels).unwrap().total();
    let mut step: Vec<f64> = (0..z.len()).map(|i| 0.2 * g.length(i).max(0.05)).collect();
    for _ in 0..400 {
        let mut any = false;
        for i in 1..z.len() {
            for s in [step[i], -step[i]] {
                z[i] += s;
                let v = g.posterior(omega, &z, labels).unwrap().total();
                if v > best {
                    best = v;
                    any = true;
                    step[i] *= 1.5;
                    break;
                } else {
                    z[i] -= s;
                }
            }
        }
        if !any {
            for s in &mut step {
                *s *= 0.5;
            }
            if step.iter().all(|s| *s < tol) {
                break;
            }
        }
    }
    (best, z)
}

fn label_ways(parents: &[u32]) -> Vec<Vec<Label>> {
    let n = parents.len();
    let mut ways = vec![vec![Label::Apical; n]];
    for p in 0..n {
        let kids: Vec<usize> = (0..n).filter(|&i| parents[i] == p as u32).collect();
        if kids.is_empty() {
            continue;
        }
        let mut perms: Vec<Vec<Label>> = vec![vec![]];
        for _ in 0..kids.len() {
            perms = perms
                .into_iter()
                .flat_map(|q| {
                    (0..kids.len()).filter_map(move |l| {
                        let lab = if l == 0 { Label::Apical } else { Label::Lateral(l as u16 - 1) };
                        if q.contains(&lab) {
                            None
                        } else {
                            let mut r = q.clone();
                            r.push(lab);
                            Some(r)
                        }
                    })
                })
                .collect();
        }
        ways = ways
            .into_iter()
            .flat_map(|w| {
                perms
                    .iter()
                    .map(|pm| {
                        let mut w = w.clone();
                        for (k, l) in kids.iter().zip(pm) {
                            w[*k] = *l;
                        }
                        w
                    })
                    .collect::<Vec<_>>()
            })
            .collect();
    }
    ways
}

fn exhaustive(g: &FactorGraph, omega: &Omega) -> f64 {
    let n = g.parents().len();
    let slopes = [-4.0, -2.0, -1.2, -0.7, -0.3, 0.0, 0.3, 0.7, 1.2, 2.0, 4.0];
    let mut top: Vec<(f64, Vec<f64>, Vec<Label>)> = vec![];
    for labels in label_ways(g.parents()) {
        let mut idx = vec![0usize; n];
        let mut z = vec![0.0; n];
        'all: loop {
            for i in 1..n {
                z[i] = z[g.parents()[i] as usize] + slopes[idx[i]] * g.length(i);
            }
            let v = g.posterior(omega, &z, &labels).unwrap().total();
            if top.len() < 60 || v > top[top.len() - 1].0 {
                let at = top.partition_point(|t| t.0 > v);
                top.insert(at, (v, z.clone(), labels.clone()));
                top.truncate(60);
            }
            for i in 1..n {
                idx[i] += 1;
                if idx[i] < slopes.len() {
                    continue 'all;
                }
                idx[i] = 0;
            }
            break;
        }
    }
    top.into_iter()
        .map(|(_, z, l)| local(g, omega, &l, z, 1e-6).0)
        .fold(f64::NEG_INFINITY, f64::max)
}

fn small() {
    let h = Habit {
        scale: Normal::new(-0.1, 0.25),
        lateral_scale: Normal::new(-0.1, 0.3),
        alpha: Normal::new(0.25, 0.12),
        beta: Normal::new(0.9, 0.2),
        gamma: Normal::new(2.4, 0.4),
    };
    let omega = Omega { orders: vec![h] };
    for s in 0..12 {
        for (name, mut params) in
            [("default", InferParams::default()), ("thesis", InferParams::thesis())]
        {
            let t = grow(&omega, 5, Seed(s));
            let pl = plan(&t, 0.7 * s as f64);
            params.keep_omega = true;
            let inf = infer(&pl, &omega, &params, Seed(s + 100), &Control::default()).unwrap();
            let g =
                FactorGraph::new(&pl, &omega, &params, Seed(s + 100), &Control::default()).unwrap();
            let best = exhaustive(&g, &omega);
            println!(
                "{s} {name}: ours {:.5} best {:.5} diff {:.5}",
                inf.posterior.total(),
                best,
                best - inf.posterior.total()
            );
        }
    }
}

fn main() {
    if std::env::args().nth(1).as_deref() == Some("small") {
        return small();
    }
    let n: usize = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(41);
    for (name, spread, comp) in [
        ("spread 0", 0.0, 5.0),
        ("spread 1", 1.0, 5.0),
        ("no competition", 1.0, 0.0),
        ("keep", 1.0, 5.0),
        ("thesis", 9.0, 5.0),
    ] {
        let h = Habit {
            scale: Normal::new(-0.1, 0.25),
            lateral_scale: Normal::new(-0.1, 0.3),
            alpha: Normal::new(0.25, 0.12),
            beta: Normal::new(0.9, 0.2),
            gamma: Normal::new(2.4, 0.4),
        };
        let omega = Omega { orders: vec![h] };
        let (mut ab, mut bb, mut sb) = (vec![], vec![], vec![]);
        let (mut a0, mut b0, mut s0) = (vec![], vec![], vec![]);
        let mut time = 0.0;
        let mut lab = (0, 0);
        for s in 0..10 {
            let t = grow(&omega, n, Seed(s));
            let pl = plan(&t, 0.7);
            let mut params = if spread == 9.0 {
                InferParams::thesis()
            } else {
                InferParams { spread, competition: comp, ..Default::default() }
            };
            params.keep_omega = name == "keep";
            let start = std::time::Instant::now();
            let inf = infer(&pl, &omega, &params, Seed(s + 100), &Control::default()).unwrap();
            time += start.elapsed().as_secs_f64();
            for w in inf.trace.windows(2) {
                assert!(w[1].posterior.total() >= w[0].posterior.total() - 1e-9, "{:?}", inf.trace);
            }
            if s == 0 {
                println!(
                    "{name}: {:?} {:.3} {:?}",
                    inf.trace
                        .iter()
                        .map(|r| (r.step, (r.posterior.total() * 100.0).round() / 100.0))
                        .collect::<Vec<_>>(),
                    inf.interpenetrations,
                    inf.posterior
                );
                if name == "spread 1" {
                    println!("{:?}", inf.omega);
                }
            }
            for r in inf.branches.relations() {
                sb.push(r.scale);
                if r.label == Label::Apical { ab.push(r.divergence) } else { bb.push(r.divergence) }
            }
            for i in 1..t.v.len() {
                let p = t.parent[i] as usize;
                let a = t.v[i].angle_between(t.v[p]);
                s0.push((t.v[i].length() / t.v[p].length()).ln());
                if t.label[i] == Label::Apical { a0.push(a) } else { b0.push(a) }
            }
            // labels agree?
            lab.1 += t.v.len();
            for i in 0..t.v.len() {
                if (t.label[i] == Label::Apical) == (inf.branches.labels()[i] == Label::Apical) {
                    lab.0 += 1
                }
            }
        }
        let deg = 57.29578;
        println!(
            "{name:16} alpha {:.1} / {:.1} KS {:.3}   beta {:.1} / {:.1} KS {:.3}  scale {:.3}/{:.3} KS {:.3}   {:.1} ms  labels {:.2}",
            med(&ab) * deg,
            med(&a0) * deg,
            ks(&mut ab, &mut a0),
            med(&bb) * deg,
            med(&b0) * deg,
            ks(&mut bb, &mut b0),
            med(&sb).exp(),
            med(&s0).exp(),
            ks(&mut sb, &mut s0),
            time * 100.0,
            lab.0 as f64 / lab.1 as f64
        );
        let _ = DVec2::ZERO;
    }
}
