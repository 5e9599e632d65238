//! Textures of a picture in progress.

use wgpu::{
    Device, Extent3d, Texture, TextureDescriptor, TextureFormat, TextureUsages, TextureView,
};

/// Format of the colours. The shader encodes them (sRGB), because user interfaces sample encoded colours.
pub(crate) const COLOR: TextureFormat = TextureFormat::Rgba8Unorm;
/// Format of the depth: reversed, 1 at the eye and 0 at infinity.
pub(crate) const DEPTH: TextureFormat = TextureFormat::Depth32Float;

/// A picture in the memory of the adapter.
pub struct Target {
    /// Width and height in pixels.
    pub size: [u32; 2],
    pub(crate) color: Texture,
    /// View of the finished picture.
    pub(crate) view: TextureView,
    pub(crate) sampled: Option<TextureView>,
    pub(crate) depth: TextureView,
}

impl Target {
    /// A target of a size, with 1 or 4 samples a pixel.
    pub fn new(device: &Device, size: [u32; 2], samples: u32) -> Self {
        let size = size.map(|side| side.clamp(1, device.limits().max_texture_dimension_2d));
        let texture = |format, samples: u32, usage| {
            device.create_texture(&TextureDescriptor {
                label: Some("target"),
                size: Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        let attachment = TextureUsages::RENDER_ATTACHMENT;
        let color = texture(
            COLOR,
            1,
            attachment | TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_SRC,
        );
        let view = color.create_view(&Default::default());
        let sampled = (samples > 1)
            .then(|| texture(COLOR, samples, attachment).create_view(&Default::default()));
        let depth = texture(DEPTH, samples, attachment).create_view(&Default::default());
        Self { size, color, view, sampled, depth }
    }
}
