//! Pictures without a window.

use crate::renderer::{Quality, Renderer};
use crate::target::Target;
use drawing::{Camera, Drawing, Image};
use wgpu::{
    BufferDescriptor, BufferUsages, Device, Instance, InstanceDescriptor, MapMode, PollType, Queue,
    TexelCopyBufferInfo, TexelCopyBufferLayout,
};

/// Bytes of a pixel in the memory of the adapter, and of a row's alignment there.
const PIXEL_BYTES: u32 = 4;

/// A renderer with an adapter of its own.
pub struct Offscreen {
    name: String,
    device: Device,
    queue: Queue,
    renderer: Renderer,
    target: Option<Target>,
}

impl Offscreen {
    /// A renderer on the best adapter of this machine, if there is one that works. The environment variable
    /// `WGPU_BACKEND` limits the choice.
    pub fn new() -> Option<Self> {
        let instance = Instance::new(InstanceDescriptor::new_without_display_handle_from_env());
        let adapter = pollster::block_on(instance.request_adapter(&Default::default())).ok()?;
        let limits = wgpu::Limits::downlevel_defaults().using_resolution(adapter.limits());
        let descriptor = wgpu::DeviceDescriptor { required_limits: limits, ..Default::default() };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).ok()?;
        let renderer = Renderer::new(&device, &queue, Quality::default());
        let info = adapter.get_info();
        let name = format!("{} ({})", info.name, info.backend);
        Some(Self { name, device, queue, renderer, target: None })
    }

    /// Name of the adapter.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Draws a picture of a size in pixels, without labels.
    pub fn picture(&mut self, drawing: &Drawing, camera: &Camera, size: [usize; 2]) -> Image {
        let size = size.map(|side| side as u32);
        let target = match self.target.take() {
            Some(target) if target.size == size => target,
            _ => self.renderer.target(size),
        };
        self.renderer.draw(&target, drawing, camera);
        let image = read(&self.device, &self.queue, &target);
        self.target = Some(target);
        image
    }
}

/// Reads the finished picture of a target back. Blocks until the adapter has drawn it.
pub fn read(device: &Device, queue: &Queue, target: &Target) -> Image {
    let [width, height] = target.size;
    let stride = (PIXEL_BYTES * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&BufferDescriptor {
        label: Some("picture"),
        size: u64::from(stride) * u64::from(height),
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    let layout =
        TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None };
    encoder.copy_texture_to_buffer(
        target.color.as_image_copy(),
        TexelCopyBufferInfo { buffer: &buffer, layout },
        target.color.size(),
    );
    queue.submit([encoder.finish()]);
    let mut pixels = Vec::with_capacity(3 * (width * height) as usize);
    buffer.map_async(MapMode::Read, .., |_| {});
    if device.poll(PollType::wait_indefinitely()).is_ok()
        && let Ok(bytes) = buffer.get_mapped_range(..)
    {
        for row in bytes.chunks_exact(stride as usize) {
            let used = &row[..(PIXEL_BYTES * width) as usize];
            pixels.extend(used.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]));
        }
    }
    pixels.resize(3 * (width * height) as usize, 0);
    Image { width: width as usize, height: height as usize, pixels }
}
