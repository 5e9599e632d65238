use scenes3d::rapier::prelude::*;
fn main() {
    let info = scenes3d::find("ragdoll_stairs").unwrap();
    let mut all = vec![];
    let mut seed = 1u64;
    let mut random = || { seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407); (seed >> 33) as f32 / (1u64 << 31) as f32 * 2.0 - 1.0 };
    for _ in 0..60 {
        let mut scene = (info.build)();
        let (v, w) = (Vector::new(random(), random(), random()) * 3.0, Vector::new(random(), random(), random()) * 5.0);
        let c = { let n = scene.world.bodies.iter().filter(|b| b.1.is_dynamic()).count() as f32; scene.world.bodies.iter().filter(|b| b.1.is_dynamic()).map(|b| b.1.translation()).fold(Vector::ZERO, |a, b| a + b) / n };
        for (_, b) in scene.world.bodies.iter_mut() { if b.is_dynamic() { let r = b.translation() - c; b.set_linvel(v + w.cross(r), true); b.set_angvel(w, true); } }
        scene.run(900);
        let gap = scene3d::gap(&scene.world);
        let sleeping = scene.world.bodies.iter().filter(|b| b.1.is_dynamic()).all(|b| b.1.is_sleeping());
        let e: f32 = scene.world.bodies.iter().map(|(_, b)| b.kinetic_energy()).sum();
        all.push((gap, sleeping, e));
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    println!("gaps: median {:.4} 80% {:.4} 95% {:.4} max {:.4}; over 5 mm {}; asleep {}; energy max {:?}", all[30].0, all[48].0, all[57].0, all[59].0, all.iter().filter(|a| a.0 > 0.005).count(), all.iter().filter(|a| a.1).count(), all.iter().map(|a| a.2).fold(0.0, f32::max));
}
