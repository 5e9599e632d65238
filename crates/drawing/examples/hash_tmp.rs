use drawing::*;
use std::hash::{Hash, Hasher};
fn h(b: &[u8]) -> u64 { let mut s = std::collections::hash_map::DefaultHasher::new(); b.hash(&mut s); s.finish() }
fn main() {
    let flat_meshes = [Mesh::disc(), Mesh::square()];
    let meshes = [Mesh::cube(), Mesh::ball(), Mesh::cylinder(), Mesh::cone()];
    for (k, view) in [View::flat(), View::orbit(30.0, 22.0), View::orbit(-70.0, 55.0), View::orbit(10.0, 5.0).focus([0.0;3],[4.0,3.0,4.0])].into_iter().enumerate() {
        let flat = k == 0;
        let mut animation = Animation::default();
        for t in 0..6 {
            let mut d = Drawing::default();
            if !flat {
                d.add(Mesh::cube(), Instance { position: [0.0,-1.0,0.0], rotation: [0.0,0.0,0.0,1.0], scale: [60.0,1.0,60.0], color: Color::from_hsl(218.0,0.16,0.4,1.0), role: Role::Ground, id: 0, highlighted: false });
            }
            for i in 0..200u32 {
                let a = 0.3 * (i as f32 + t as f32);
                let (s, c) = (a.sin(), a.cos());
                let rotation = if flat { [0.0, 0.0, s, c] } else { let n = (1.0f32+0.25+0.04).sqrt(); [s/n, 0.5*s/n, 0.2*s/n, (1.0 - s*s).sqrt()] };
                let position = if flat { [(i % 20) as f32 * 1.1, (i / 20) as f32 * 1.3 + 0.1 * t as f32, 0.0] } else { [(i % 6) as f32 * 1.2, (i / 36) as f32 + 0.05 * t as f32, (i / 6 % 6) as f32 * 1.1] };
                let mesh = if flat { flat_meshes[i as usize % 2] } else { meshes[i as usize % 4] };
                d.add(mesh, Instance { position, rotation, scale: [0.5, 0.4, 0.45], color: Color::from_hsl(37.0 * i as f32, 0.7, 0.6, 1.0), role: if i % 9 == 0 { Role::Fixed } else { Role::Moving }, id: i, highlighted: i == 7 });
            }
            d.line(Line { from: [0.0, 0.0, 0.0], to: [5.0, 5.0, 2.0], color: Color::from_hsl(50.0, 1.0, 0.6, 1.0), on_top: true });
            d.label([1.0, 2.0, 0.0], "WORD 12"); d.label([100.0, 2.0, 0.0], "OUT");
            let size = [480, 270];
            let camera = Camera::fit(&view, &d.points_to_frame(), 480.0/270.0);
            let p = raster::picture(&d, &camera, size);
            let w = raster::write(&p, &camera, &d.labels, &["title".into(), "details".into()]);
            if t == 0 { println!("{k} {:016x} {:016x} {:?}", h(&p.pixels), h(&w.pixels), camera);
              // A near camera: triangles are clipped.
              let near = Camera::looking([3.0, 1.5, 3.0], [0.0, 0.0, 0.0], 1.7);
              if !flat { println!("  near {:016x}", h(&raster::picture(&d, &near, size).pixels)); }
              if k == 1 { w.save(std::path::Path::new("/tmp/a-hash.png")).unwrap(); }
            }
            animation.push(w);
        }
        let path = std::path::PathBuf::from(format!("/tmp/a-anim-{k}.png"));
        animation.save(&path, 30).unwrap();
        println!("  anim {:016x}", h(&std::fs::read(&path).unwrap()));
    }
}
