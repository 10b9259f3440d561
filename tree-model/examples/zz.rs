use std::time::Instant; use tree_model::particle::{Grid, flow::*}; use tree_model::glam::*; use tree_core::*;
fn main(){ let corner = Vec3::new(-4.0, 0.0, -4.0);
    let mut grid = Grid::new(corner, 0.2, UVec3::new(40, 50, 40), &Limits::default()).unwrap();
    for i in 0..grid.values().len() { let p = grid.center(grid.voxel_of(i));
        let c = p.distance(Vec3::new(0.0, 6.5, 0.0)) < 3.2; let t = p.y < 4.0 && Vec3::new(p.x, 0.0, p.z).length() < 0.3;
        grid.values_mut()[i] = f32::from(u8::from(c || t)); }
    let control=Control::default(); let params=FlowParams::default();
    let t=Instant::now(); let way=Way::new(&grid,&params,&control).unwrap(); println!("way {:?}",t.elapsed());
    for n in [2000,20000] { let mut rng=Seed(1).rng(); let starts:Vec<Vec3>=(0..n).map(|_| 3.0*seed::in_unit_ball(&mut rng)+6.5*Vec3::Y).collect();
      for _ in 0..3 { let t=Instant::now(); let f=run(&starts,10.0,&Forces::new(&[],&way,&params),&params,&control).unwrap(); println!("{n}: {:?} {:?} nodes {}",t.elapsed(),f.report,f.traces.positions().len()); } } }
