//! Draws a drawing into a target.

use crate::buffers::{Buffers, Call};
use crate::pipelines::Pipelines;
use crate::target::{DEPTH, Target};
use crate::uniforms::{self, Sun};
use drawing::{Camera, Drawing};
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor,
    BindGroupLayoutEntry, BindingResource, BindingType, Buffer, BufferBindingType, BufferUsages,
    Color, CommandEncoder, CompareFunction, Device, Extent3d, FilterMode, IndexFormat, LoadOp,
    Operations, Queue, RenderPass, RenderPassColorAttachment, RenderPassDepthStencilAttachment,
    RenderPassDescriptor, SamplerDescriptor, ShaderStages, StoreOp, TextureDescriptor,
    TextureUsages, TextureView,
};

/// Cost limits of a picture.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Quality {
    /// Samples a pixel: 1 or 4.
    pub samples: u32,
    /// Side of the shadow map in texels; 0 draws no shadows.
    pub shadow_texels: u32,
    /// Number of pictures that share a shadow map. A map costs as much as a picture without shadows.
    pub shadow_life: u32,
}

impl Quality {
    /// Returns the quality for a window. On software adapters, borders are not smoothed and shadows are
    /// coarse.
    pub fn for_adapter(adapter: &wgpu::Adapter) -> Self {
        match adapter.get_info().device_type {
            wgpu::DeviceType::Cpu => Self { samples: 1, shadow_texels: 1024, shadow_life: 3 },
            _ => Self::default(),
        }
    }
}

impl Default for Quality {
    fn default() -> Self {
        Self { samples: 4, shadow_texels: drawing::light::SHADOW_TEXELS as u32, shadow_life: 1 }
    }
}

/// A renderer: pipelines, and buffers that last from picture to picture.
pub struct Renderer {
    device: Device,
    queue: Queue,
    quality: Quality,
    pipelines: Pipelines,
    buffers: Buffers,
    uniforms: Buffer,
    shadow_map: TextureView,
    view: BindGroup,
    sun_view: BindGroup,
    /// Matrix of the shadow map, and the number of pictures for which it remains valid.
    sun: (Sun, u32),
}

impl Renderer {
    /// A renderer on a device.
    pub fn new(device: &Device, queue: &Queue, quality: Quality) -> Self {
        let shader = device.create_shader_module(wgpu::include_wgsl!("shader.wgsl"));
        let [view_layout, sun_layout] = layouts(device);
        let pipelines =
            Pipelines::new(device, &shader, [&view_layout, &sun_layout], quality.samples);
        let uniforms = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("view"),
            size: 16 * uniforms::ROWS as u64,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let shadow_map = shadow_map(device, quality.shadow_texels.max(1));
        let sampler = device.create_sampler(&SamplerDescriptor {
            label: Some("shadow"),
            mag_filter: FilterMode::Linear,
            min_filter: FilterMode::Linear,
            compare: Some(CompareFunction::LessEqual),
            ..Default::default()
        });
        let numbers = BindGroupEntry { binding: 0, resource: uniforms.as_entire_binding() };
        let group = |label, layout: &BindGroupLayout, entries: &[BindGroupEntry]| {
            device.create_bind_group(&BindGroupDescriptor { label: Some(label), layout, entries })
        };
        let map =
            BindGroupEntry { binding: 1, resource: BindingResource::TextureView(&shadow_map) };
        let sampler = BindGroupEntry { binding: 2, resource: BindingResource::Sampler(&sampler) };
        let sun_view = group("sun", &sun_layout, std::slice::from_ref(&numbers));
        let view = group("view", &view_layout, &[numbers, map, sampler]);
        Self {
            device: device.clone(),
            queue: queue.clone(),
            quality,
            pipelines,
            buffers: Buffers::new(device),
            uniforms,
            shadow_map,
            view,
            sun_view,
            sun: (Sun::default(), 0),
        }
    }

    /// Returns the quality of the renderer.
    pub fn quality(&self) -> Quality {
        self.quality
    }

    /// A target of the renderer's number of samples.
    pub fn target(&self, size: [u32; 2]) -> Target {
        Target::new(&self.device, size, self.quality.samples)
    }

    /// Requests a new shadow map for the next picture.
    pub fn renew_shadows(&mut self) {
        self.sun.1 = 0;
    }

    /// Draws a picture, without labels, into a target of this renderer.
    pub fn draw(&mut self, target: &Target, drawing: &Drawing, camera: &Camera) {
        let texels = if camera.flat { 0 } else { self.quality.shadow_texels };
        let new_shadows = texels > 0 && self.sun.1 == 0;
        if new_shadows {
            self.sun = (uniforms::sun(camera, texels), self.quality.shadow_life);
        }
        self.sun.1 = self.sun.1.saturating_sub(1);
        let sun = (texels > 0).then_some(&self.sun.0);
        let rows = uniforms::rows(camera, target.size, sun);
        self.queue.write_buffer(&self.uniforms, 0, bytemuck::cast_slice(&rows));
        let height = target.size[1] as f32;
        let (calls, lines) =
            self.buffers.upload((&self.device, &self.queue), drawing, camera, height);
        let mut encoder = self.device.create_command_encoder(&Default::default());
        if new_shadows {
            self.draw_shadows(&mut encoder, &calls);
        }
        self.draw_scene(&mut encoder, target, &calls, lines);
        self.queue.submit([encoder.finish()]);
    }

    fn draw_shadows(&self, encoder: &mut CommandEncoder, calls: &[Call]) {
        let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
            label: Some("shadow"),
            color_attachments: &[],
            depth_stencil_attachment: Some(depth(&self.shadow_map, 1.0, StoreOp::Store)),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipelines.shadow);
        pass.set_bind_group(0, &self.sun_view, &[]);
        pass.set_vertex_buffer(1, self.buffers.instances().slice(..));
        for call in calls {
            self.draw_mesh(&mut pass, call.shadow, call);
        }
    }

    fn draw_scene(
        &self,
        encoder: &mut CommandEncoder,
        target: &Target,
        calls: &[Call],
        lines: u32,
    ) {
        let (view, resolve_target, store) = match &target.sampled {
            Some(sampled) => (sampled, Some(&target.view), StoreOp::Discard),
            None => (&target.view, None, StoreOp::Store),
        };
        let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
            label: Some("scene"),
            color_attachments: &[Some(RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: Operations { load: LoadOp::Clear(Color::BLACK), store },
            })],
            depth_stencil_attachment: Some(depth(&target.depth, 0.0, StoreOp::Discard)),
            ..Default::default()
        });
        pass.set_bind_group(0, &self.view, &[]);
        pass.set_pipeline(&self.pipelines.sky);
        pass.draw(0..3, 0..1);
        pass.set_vertex_buffer(1, self.buffers.instances().slice(..));
        for (pipeline, closed) in [(&self.pipelines.closed, true), (&self.pipelines.surface, false)]
        {
            pass.set_pipeline(pipeline);
            let is_closed =
                |call: &&Call| self.buffers.mesh(call.mesh).is_some_and(|mesh| mesh.closed);
            for call in calls.iter().filter(|call| is_closed(call) == closed) {
                self.draw_mesh(&mut pass, call.mesh, call);
            }
        }
        if lines > 0 {
            pass.set_pipeline(&self.pipelines.line);
            pass.set_vertex_buffer(0, self.buffers.lines().slice(..));
            pass.draw(0..4, 0..lines);
        }
    }

    fn draw_mesh(&self, pass: &mut RenderPass, mesh: usize, call: &Call) {
        let Some(mesh) = self.buffers.mesh(mesh) else { return };
        pass.set_vertex_buffer(0, mesh.vertices.slice(..));
        pass.set_index_buffer(mesh.indices.slice(..), IndexFormat::Uint32);
        pass.draw_indexed(0..mesh.index_count, 0, call.instances.clone());
    }
}

fn depth(view: &TextureView, clear: f32, store: StoreOp) -> RenderPassDepthStencilAttachment<'_> {
    RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(Operations { load: LoadOp::Clear(clear), store }),
        stencil_ops: None,
    }
}

/// Layouts of the bindings of the picture's passes, and of the shadow map's pass.
fn layouts(device: &Device) -> [BindGroupLayout; 2] {
    let entry =
        |binding, visibility, ty| BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let numbers = entry(
        0,
        ShaderStages::VERTEX_FRAGMENT,
        BindingType::Buffer {
            ty: BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
    );
    let map = entry(
        1,
        ShaderStages::FRAGMENT,
        BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Depth,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
    );
    let sampler = entry(
        2,
        ShaderStages::FRAGMENT,
        BindingType::Sampler(wgpu::SamplerBindingType::Comparison),
    );
    let layout = |label, entries: &[BindGroupLayoutEntry]| {
        device.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some(label), entries })
    };
    [layout("view", &[numbers, map, sampler]), layout("sun", &[numbers])]
}

fn shadow_map(device: &Device, texels: u32) -> TextureView {
    let texture = device.create_texture(&TextureDescriptor {
        label: Some("shadow"),
        size: Extent3d { width: texels, height: texels, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: DEPTH,
        usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&Default::default())
}
