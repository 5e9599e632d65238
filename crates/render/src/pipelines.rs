//! The pipelines: sky, surfaces, lines, shadow map.

use crate::buffers::{INSTANCE_NUMBERS, LINE_NUMBERS};
use crate::target::{COLOR, DEPTH};
use wgpu::{
    BindGroupLayout, BlendState, ColorTargetState, ColorWrites, CompareFunction, DepthBiasState,
    DepthStencilState, Device, Face, FragmentState, MultisampleState, PipelineCompilationOptions,
    PipelineLayoutDescriptor, PrimitiveState, PrimitiveTopology, RenderPipeline,
    RenderPipelineDescriptor, ShaderModule, StencilState, VertexBufferLayout, VertexState,
    VertexStepMode, vertex_attr_array,
};

/// The pipelines for a number of samples a pixel.
pub(crate) struct Pipelines {
    pub sky: RenderPipeline,
    /// Surfaces that are visible from both sides.
    pub surface: RenderPipeline,
    /// Surfaces of solid shapes, which are visible from outside.
    pub closed: RenderPipeline,
    pub line: RenderPipeline,
    pub shadow: RenderPipeline,
}

/// The parts in which the pipelines differ.
struct Recipe<'a> {
    label: &'static str,
    vertex: &'static str,
    fragment: Option<&'static str>,
    buffers: &'a [Option<VertexBufferLayout<'a>>],
    topology: PrimitiveTopology,
    writes_depth: bool,
    cull_mode: Option<Face>,
    compare: CompareFunction,
    samples: u32,
}

impl Pipelines {
    /// Pipelines whose shaders read the view through `view`, and the shadow map's ones through `sun_view`.
    pub(crate) fn new(
        device: &Device,
        shader: &ShaderModule,
        [view, sun_view]: [&BindGroupLayout; 2],
        samples: u32,
    ) -> Self {
        let vertices = vertex_attr_array![0 => Float32x3, 1 => Float32x3];
        let instances = vertex_attr_array![2 => Float32x3, 3 => Float32x4, 4 => Float32x3, 5 => Float32x4, 6 => Uint32];
        let strokes =
            vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x4, 3 => Float32];
        let layout = |numbers: usize, step_mode, attributes| {
            Some(VertexBufferLayout { array_stride: 4 * numbers as u64, step_mode, attributes })
        };
        let solid = [
            layout(6, VertexStepMode::Vertex, &vertices[..]),
            layout(INSTANCE_NUMBERS, VertexStepMode::Instance, &instances[..]),
        ];
        let stroke = [layout(LINE_NUMBERS, VertexStepMode::Instance, &strokes[..])];
        let surface = Recipe {
            label: "surface",
            vertex: "surface_vertex",
            fragment: Some("surface_fragment"),
            buffers: &solid,
            topology: PrimitiveTopology::TriangleList,
            writes_depth: true,
            cull_mode: None,
            compare: CompareFunction::GreaterEqual,
            samples,
        };
        let shadow = Recipe {
            label: "shadow",
            vertex: "shadow_vertex",
            fragment: None,
            compare: CompareFunction::Less,
            samples: 1,
            ..surface
        };
        let line = Recipe {
            label: "line",
            vertex: "line_vertex",
            fragment: Some("line_fragment"),
            buffers: &stroke,
            topology: PrimitiveTopology::TriangleStrip,
            ..surface
        };
        let sky = Recipe {
            label: "sky",
            vertex: "sky_vertex",
            fragment: Some("sky_fragment"),
            buffers: &[],
            writes_depth: false,
            compare: CompareFunction::Always,
            ..surface
        };
        Self {
            sky: sky.build(device, shader, view),
            line: line.build(device, shader, view),
            shadow: shadow.build(device, shader, sun_view),
            closed: Recipe { cull_mode: Some(Face::Back), ..surface }.build(device, shader, view),
            surface: surface.build(device, shader, view),
        }
    }
}

impl Recipe<'_> {
    fn build(
        &self,
        device: &Device,
        shader: &ShaderModule,
        view: &BindGroupLayout,
    ) -> RenderPipeline {
        let layout = device.create_pipeline_layout(&PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: &[Some(view)],
            immediate_size: 0,
        });
        let taps = [("taps", if self.samples > 1 { 4.0 } else { 1.0 })];
        let target = [Some(ColorTargetState {
            format: COLOR,
            blend: Some(BlendState::ALPHA_BLENDING),
            write_mask: ColorWrites::ALL,
        })];
        device.create_render_pipeline(&RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&layout),
            vertex: VertexState {
                module: shader,
                entry_point: Some(self.vertex),
                compilation_options: Default::default(),
                buffers: self.buffers,
            },
            primitive: PrimitiveState {
                topology: self.topology,
                cull_mode: self.cull_mode,
                ..Default::default()
            },
            depth_stencil: Some(DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(self.writes_depth),
                depth_compare: Some(self.compare),
                stencil: StencilState::default(),
                bias: DepthBiasState::default(),
            }),
            multisample: MultisampleState { count: self.samples, ..Default::default() },
            fragment: self.fragment.map(|entry_point| FragmentState {
                module: shader,
                entry_point: Some(entry_point),
                compilation_options: PipelineCompilationOptions {
                    constants: &taps,
                    ..Default::default()
                },
                targets: &target,
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
