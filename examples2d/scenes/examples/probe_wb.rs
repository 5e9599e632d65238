use gallery::SceneRun;
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let info = scenes2d::find(&name).unwrap();
    let mut scene = (info.build)();
    let (mut worst, mut gaps) = (0.0f64, 0.0f64);
    for step in 1..=1200 {
        scene.run(1);
        let s = scene.stats();
        worst = worst.max(s.penetration);
        let gap = scene.world.impulse_joints.iter().map(|(_, joint)| { let w = &scene.world;
            let (a, b) = (&w.bodies[joint.body1()], &w.bodies[joint.body2()]);
            let p = a.position().transform_point(joint.data.local_anchor1());
            let q = b.position().transform_point(joint.data.local_anchor2());
            (p - q).length() as f64 }).fold(0.0, f64::max);
        gaps = gaps.max(gap);
        if step % 20 == 0 {
            let e: f32 = scene.world.bodies.iter().map(|(_, b)| b.kinetic_energy()).sum();
            println!("{step} overlap {:.4} worst {:.4} gap {gap:.4} worst {gaps:.4} energy {e:.1}", s.penetration, worst); worst = 0.0; gaps = 0.0; }
    }
}
