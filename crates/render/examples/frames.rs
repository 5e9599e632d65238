//! Times frames of 5,000 boxes and balls on the adapter of this machine, for each quality:
//! `cargo run --release -p render --example frames -- 1000 780`.

use drawing::{Color, Drawing, Instance, Mesh, Role, View};
use render::wgpu::{self, Instance as Adapters, InstanceDescriptor, PollType};
use render::{Quality, Renderer};
use std::time::Instant;

/// Bodies along each side of the block.
const SIDES: [usize; 3] = [25, 8, 25];
/// Frames that are timed.
const FRAMES: u32 = 20;

fn block() -> Drawing {
    let mut drawing = Drawing::default();
    let base = Instance {
        position: [0.0, -1.0, 0.0],
        rotation: [0.0, 0.0, 0.0, 1.0],
        scale: [60.0, 1.0, 60.0],
        color: Color::from_hsl(218.0, 0.16, 0.4, 1.0),
        role: Role::Ground,
        id: 0,
        highlighted: false,
    };
    drawing.add(Mesh::cube(), base);
    for i in 0..SIDES.iter().product() {
        let cell = [i % SIDES[0], i / SIDES[0] % SIDES[1], i / SIDES[0] / SIDES[1]];
        let position = [0, 1, 2].map(|axis| 1.2 * cell[axis] as f32 + 0.5);
        let color = Color::from_hsl(40.0 * i as f32, 0.7, 0.6, 1.0);
        let mesh = if i % 2 == 0 { Mesh::cube() } else { Mesh::ball() };
        drawing
            .add(mesh, Instance { position, scale: [0.5; 3], color, role: Role::Moving, ..base });
    }
    drawing
}

/// Milliseconds that all processors have spent on this process (Linux; elsewhere 0).
fn processor_ms() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields = stat.rsplit(')').next().unwrap_or_default().split_whitespace();
    // Ticks of 10 ms in user and in system mode.
    fields.skip(11).take(2).filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() * 10.0
}

fn main() {
    let sizes: Vec<u32> = std::env::args().skip(1).filter_map(|side| side.parse().ok()).collect();
    let size = if let [width, height] = sizes[..] { [width, height] } else { [1000, 780] };
    let instance = Adapters::new(InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()));
    let adapter = adapter.expect("there is an adapter");
    let device = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()));
    let (device, queue) = device.expect("it has a device");
    println!("{} at {size:?}", adapter.get_info().name);
    let drawing = block();
    let camera = drawing.camera(&View::orbit(30.0, 25.0), size.map(|side| side as usize));
    for (samples, shadow_texels, shadow_life) in
        [(1, 0, 1), (1, 1024, 3), (1, 2048, 1), (4, 2048, 1)]
    {
        let quality = Quality { samples, shadow_texels, shadow_life };
        let mut renderer = Renderer::new(&device, &queue, quality);
        let target = renderer.target(size);
        let mut frame = || {
            renderer.draw(&target, &drawing, &camera);
            device.poll(PollType::wait_indefinitely()).expect("the adapter answers");
        };
        frame();
        let (start, processor) = (Instant::now(), processor_ms());
        (0..FRAMES).for_each(|_| frame());
        let ms = start.elapsed().as_secs_f64() * 1.0e3 / f64::from(FRAMES);
        let processor = (processor_ms() - processor) / f64::from(FRAMES);
        println!(
            "{samples} samples, shadow map of {shadow_texels:4} for {shadow_life}: {ms:6.1} ms a frame, {processor:.0} ms of the processors"
        );
    }
}
