use crate::dim::grounds::{ASIDE, GROUNDS, sliders};
use crate::dim::vec;
use crate::suite::physics::stage::world;
use rapier::prelude::*;
#[test]
fn debug() {
    let (_, lay) = GROUNDS[std::env::var("G").unwrap().parse::<usize>().unwrap()];
    let (_, height, pose, collider) =
        sliders().remove(std::env::var("S").unwrap().parse::<usize>().unwrap());
    let mut world = world(60);
    lay(&mut world, Pose::IDENTITY, 0.0);
    let body = RigidBodyBuilder::dynamic()
        .pose(Pose::from_translation(vec(-1.5, height) + ASIDE) * pose)
        .linvel(vec(10.0, 0.0));
    let (body, _) = world.insert(body, collider.friction(0.0));
    let mut last = vec(0.0, 0.0);
    for step in 0..240 {
        let w0 = crate::dim::ang_length(world.bodies[body].angvel());
        world.step();
        let b = &world.bodies[body];
        let w = crate::dim::ang_length(b.angvel());
        if (w - w0).abs() > 0.03
            || (b.linvel() - last).length() > 0.1
            || std::env::var("ALL").is_ok()
        {
            println!("step {step} at {:?} v {:?} w {:?}", b.translation(), b.linvel(), b.angvel());
            for (_, _, pair) in world.contact_pairs() {
                for m in &pair.manifolds {
                    println!(
                        "   {:?} parts {} {} n {:?}",
                        (pair.collider1, pair.collider2),
                        m.subshape1,
                        m.subshape2,
                        m.data.normal
                    );
                    for p in m.contacts() {
                        println!(
                            "      {:?} {:?} dist {:.5} imp {:.4} {:?} {:?}",
                            p.local_p1, p.local_p2, p.dist, p.impulse, p.fid1, p.fid2
                        );
                    }
                }
            }
        }
        last = b.linvel();
    }
}
