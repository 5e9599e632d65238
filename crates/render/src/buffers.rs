//! Meshes, instances and lines in the memory of the adapter.

use drawing::{Camera, Drawing, Instance, Line, Mesh, Role};
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device, Queue};

/// Frames after which the buffers of a mesh that no drawing contains are dropped.
const MESH_LIFE: u64 = 240;
/// Flags of instances, as in the shader.
const GROUND: u32 = 1;
const HIGHLIGHTED: u32 = 2;
/// Numbers of an instance and of a line.
pub(crate) const INSTANCE_NUMBERS: usize = 16;
pub(crate) const LINE_NUMBERS: usize = 11;

/// The buffers of a mesh.
pub(crate) struct MeshBuffers {
    pub vertices: Buffer,
    pub indices: Buffer,
    pub index_count: u32,
    pub closed: bool,
    /// Keeps the mesh alive, so that its address stays unique.
    _mesh: Arc<Mesh>,
    last_used: u64,
}

/// Draw call: a mesh and the coarse mesh of its shadow, by their addresses, and a range of instances.
pub(crate) struct Call {
    pub mesh: usize,
    pub shadow: usize,
    pub instances: Range<u32>,
}

/// All buffers of a renderer.
pub(crate) struct Buffers {
    meshes: HashMap<usize, MeshBuffers>,
    frame: u64,
    instances: Growing,
    lines: Growing,
}

impl Buffers {
    pub(crate) fn new(device: &Device) -> Self {
        Self {
            meshes: HashMap::new(),
            frame: 0,
            instances: Growing::new(device, "instances"),
            lines: Growing::new(device, "lines"),
        }
    }

    /// Uploads a drawing. Returns its draw calls and the number of its lines.
    pub(crate) fn upload(
        &mut self,
        (device, queue): (&Device, &Queue),
        drawing: &Drawing,
        camera: &Camera,
        height: f32,
    ) -> (Vec<Call>, u32) {
        self.frame += 1;
        let mut numbers: Vec<[f32; INSTANCE_NUMBERS]> = Vec::new();
        let mut calls = Vec::new();
        for batch in &drawing.batches {
            let forms = batch.mesh.coarse.len() + 1;
            let mut parts: Vec<Vec<(f32, &Instance)>> = vec![Vec::new(); forms];
            for instance in &batch.instances {
                let form = batch.mesh.detail(camera, instance, height).map_or(0, |form| form + 1);
                parts[form].push((camera.see(instance.position).w, instance));
            }
            for (form, mut part) in parts.into_iter().enumerate() {
                let mesh = if form == 0 { &batch.mesh } else { &batch.mesh.coarse[form - 1].0 };
                if part.is_empty() || mesh.triangles.is_empty() {
                    continue;
                }
                // Near instances come first and hide the others, whose pixels then need no shading. Flat
                // scenes keep their order.
                part.sort_by(|a, b| a.0.total_cmp(&b.0));
                let first = numbers.len() as u32;
                numbers.extend(part.into_iter().map(|(_, instance)| numbers_of(instance)));
                let address = self.keep(device, mesh);
                let shadow = batch.mesh.coarse.last().map_or(&batch.mesh, |(mesh, _)| mesh);
                let shadow = self.keep(device, shadow);
                calls.push(Call { mesh: address, shadow, instances: first..numbers.len() as u32 });
            }
        }
        self.instances.write(device, queue, numbers.as_flattened());
        let lines: Vec<_> = drawing.lines.iter().map(numbers_of_line).collect();
        self.lines.write(device, queue, lines.as_flattened());
        let frame = self.frame;
        self.meshes.retain(|_, mesh| mesh.last_used + MESH_LIFE > frame);
        (calls, lines.len() as u32)
    }

    fn keep(&mut self, device: &Device, mesh: &Arc<Mesh>) -> usize {
        let address = Arc::as_ptr(mesh) as usize;
        let frame = self.frame;
        let entry = self.meshes.entry(address);
        entry.or_insert_with(|| upload_mesh(device, mesh)).last_used = frame;
        address
    }

    pub(crate) fn mesh(&self, address: usize) -> Option<&MeshBuffers> {
        self.meshes.get(&address)
    }

    pub(crate) fn instances(&self) -> &Buffer {
        &self.instances.buffer
    }

    pub(crate) fn lines(&self) -> &Buffer {
        &self.lines.buffer
    }
}

fn upload_mesh(device: &Device, mesh: &Arc<Mesh>) -> MeshBuffers {
    let vertices: Vec<[f32; 6]> = mesh
        .vertices
        .iter()
        .map(|v| {
            let ([x, y, z], [nx, ny, nz]) = (v.position, v.normal);
            [x, y, z, nx, ny, nz]
        })
        .collect();
    let buffer = |label, contents: &[u8], usage| {
        device.create_buffer_init(&BufferInitDescriptor { label: Some(label), contents, usage })
    };
    MeshBuffers {
        vertices: buffer("vertices", bytemuck::cast_slice(&vertices), BufferUsages::VERTEX),
        indices: buffer("indices", bytemuck::cast_slice(&mesh.triangles), BufferUsages::INDEX),
        index_count: 3 * mesh.triangles.len() as u32,
        closed: mesh.closed,
        _mesh: mesh.clone(),
        last_used: 0,
    }
}

fn numbers_of(instance: &Instance) -> [f32; INSTANCE_NUMBERS] {
    let ([px, py, pz], [rx, ry, rz, rw]) = (instance.position, instance.rotation);
    let ([sx, sy, sz], [r, g, b]) = (instance.scale, instance.color.to_light());
    let ground = if instance.role == Role::Ground { GROUND } else { 0 };
    let flags = ground | if instance.highlighted { HIGHLIGHTED } else { 0 };
    let opacity = instance.color.opacity;
    [px, py, pz, rx, ry, rz, rw, sx, sy, sz, r, g, b, opacity, f32::from_bits(flags), 0.0]
}

fn numbers_of_line(line: &Line) -> [f32; LINE_NUMBERS] {
    let ([ax, ay, az], [bx, by, bz], [r, g, b]) = (line.from, line.to, line.color.to_light());
    [ax, ay, az, bx, by, bz, r, g, b, line.color.opacity, if line.on_top { 1.0 } else { 0.0 }]
}

/// A vertex buffer that grows.
struct Growing {
    buffer: Buffer,
    label: &'static str,
}

impl Growing {
    fn new(device: &Device, label: &'static str) -> Self {
        Self { buffer: empty(device, label, 1 << 16), label }
    }

    fn write(&mut self, device: &Device, queue: &Queue, numbers: &[f32]) {
        let bytes: &[u8] = bytemuck::cast_slice(numbers);
        if bytes.len() as u64 > self.buffer.size() {
            self.buffer = empty(device, self.label, (bytes.len() as u64).next_power_of_two());
        }
        if !bytes.is_empty() {
            queue.write_buffer(&self.buffer, 0, bytes);
        }
    }
}

fn empty(device: &Device, label: &'static str, size: u64) -> Buffer {
    let usage = BufferUsages::VERTEX | BufferUsages::COPY_DST;
    device.create_buffer(&BufferDescriptor {
        label: Some(label),
        size,
        usage,
        mapped_at_creation: false,
    })
}
