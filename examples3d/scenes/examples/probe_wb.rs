use gallery::SceneRun;
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let every: usize = std::env::args().nth(2).unwrap().parse().unwrap();
    let info = scenes3d::find(&name).unwrap();
    let mut scene = (info.build)();
    let (mut worst, mut gaps) = (0.0f64, 0.0f64);
    for step in 1..=1200 {
        scene.run(1);
        let s = scene.stats();
        worst = worst.max(s.penetration);
        let gap = scene3d::gap(&scene.world);
        gaps = gaps.max(gap);
        if step % every == 0 {
            let e: f32 = scene.world.bodies.iter().map(|(_, b)| b.kinetic_energy()).sum();
            let reach = scene.world.bodies.iter().filter(|(_, b)| b.is_dynamic()).map(|(_, b)| b.translation().length()).fold(0.0, f32::max);
            println!("{step} overlap {:.4} worst {:.4} gap {gap:.4} worst {gaps:.4} energy {e:.1} reach {reach:.2}", s.penetration, worst); worst = 0.0; gaps = 0.0; }
    }
}
