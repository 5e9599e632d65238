//! Copies a finished picture into a window's pass.

use crate::target::Target;
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindingResource, Device, FilterMode,
    FragmentState, MultisampleState, PipelineCompilationOptions, PrimitiveState, RenderPass,
    RenderPipeline, RenderPipelineDescriptor, Sampler, SamplerDescriptor, TextureFormat,
    VertexState,
};

/// Copies pictures into passes of one colour format, one sample a pixel and no depth.
///
/// The copy neither blends nor tints. Software adapters draw the images of a user interface several times
/// more slowly.
pub struct Blit {
    pipeline: RenderPipeline,
    sampler: Sampler,
}

/// A picture that a pass can copy.
#[derive(Clone)]
pub struct Copyable {
    pipeline: RenderPipeline,
    picture: BindGroup,
}

impl Blit {
    /// Creates a copy into passes with this target format. The filter is for pictures of another size than
    /// the viewport.
    pub fn new(device: &Device, format: TextureFormat, filter: FilterMode) -> Self {
        let shader = device.create_shader_module(wgpu::include_wgsl!("blit.wgsl"));
        let decodes = [("decodes", f64::from(u8::from(format.is_srgb())))];
        let pipeline = device.create_render_pipeline(&RenderPipelineDescriptor {
            label: Some("blit"),
            layout: None,
            vertex: VertexState {
                module: &shader,
                entry_point: Some("blit_vertex"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: PrimitiveState::default(),
            depth_stencil: None,
            multisample: MultisampleState::default(),
            fragment: Some(FragmentState {
                module: &shader,
                entry_point: Some("blit_fragment"),
                compilation_options: PipelineCompilationOptions {
                    constants: &decodes,
                    ..Default::default()
                },
                targets: &[Some(format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let sampler = device.create_sampler(&SamplerDescriptor {
            label: Some("blit"),
            mag_filter: filter,
            min_filter: filter,
            ..Default::default()
        });
        Self { pipeline, sampler }
    }

    /// Returns the picture of a target. The copy shows the target's content at the time of the pass.
    pub fn picture(&self, device: &Device, target: &Target) -> Copyable {
        let entries = [
            BindGroupEntry { binding: 0, resource: BindingResource::TextureView(&target.view) },
            BindGroupEntry { binding: 1, resource: BindingResource::Sampler(&self.sampler) },
        ];
        let layout = &self.pipeline.get_bind_group_layout(0);
        let descriptor = BindGroupDescriptor { label: Some("blit"), layout, entries: &entries };
        Copyable { pipeline: self.pipeline.clone(), picture: device.create_bind_group(&descriptor) }
    }
}

impl Copyable {
    /// Fills the viewport of a pass with the picture.
    pub fn copy_into(&self, pass: &mut RenderPass) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.picture, &[]);
        pass.draw(0..3, 0..1);
    }
}
