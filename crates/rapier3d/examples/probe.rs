use rapier3d::prelude::*;
fn tower(n: usize, half: [f32;3], tilt: f32, iters: usize, seconds: f32, rate: f32) -> (f32, f32, usize) {
    let mut w = PhysicsWorld::new();
    w.integration_parameters.dt = 1.0/rate;
    w.integration_parameters.num_solver_iterations = iters; w.integration_parameters.allowed_linear_error = std::env::var("SLOP").map_or(0.001, |a| a.parse().unwrap());
    let rot = Rotation::from_axis_angle(Vector::Z, tilt);
    let up = rot * Vector::Y; 
    w.insert(RigidBodyBuilder::fixed().translation(up * -0.5).rotation(Vector::new(0.0,0.0,tilt)), ColliderBuilder::cuboid(20.0,0.5,20.0).friction(1.0));
    let hs: Vec<_> = (0..n).map(|k| w.insert(RigidBodyBuilder::dynamic().translation(up * (half[1]*(2*k+1) as f32)).rotation(Vector::new(0.0,0.0,tilt)), ColliderBuilder::cuboid(half[0],half[1],half[2]).friction(1.0)).0).collect();
    let mut slept = 0;
    for s in 0..(seconds*rate) as usize { w.step(); if slept==0 && w.active_bodies().is_empty() { slept = s; break; } }
    let top = w.bodies[hs[n-1]].translation();
    let full = half[1]*(2*n-1) as f32;
    (up.dot(top)/full, (top - up*up.dot(top)).length()/full, slept)
}
fn main() {
    let secs: f32 = std::env::args().nth(1).map_or(15.0, |a| a.parse().unwrap());
    for (n, half) in [(10,[0.5f32;3]),(20,[0.5;3]),(30,[0.5;3]),(10,[0.05;3]),(20,[0.05;3]),(20,[0.1,0.01,0.1])] {
        let tip = (half[0]/half[1]/n as f32).atan();
        for factor in [1,2,4,8] {
            print!("n {n} half {half:?} x{factor}: ");
            for f in [0.0,0.1,0.3,0.5,0.7,0.9] {
                let (h, l, sl) = tower(n, half, tip*f, 4*factor, secs, 60.0);
                print!(" {f}:{}{:.3}/{:.3}{}", if h>0.9 {"ok "} else {"FALL "}, h, l, if sl>0 {format!("z{sl}")} else {"".into()});
            }
            println!();
        }
    }
}
