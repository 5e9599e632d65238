// Copies a finished picture into the viewport of a pass.

// Whether the target of the pass encodes colours (sRGB), which the picture has encoded already.
override decodes: bool = false;

@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var filtering: sampler;

struct Corner {
    @builtin(position) clip: vec4<f32>,
    @location(0) at: vec2<f32>,
};

// One triangle, twice as wide and high as the viewport.
@vertex
fn blit_vertex(@builtin(vertex_index) corner: u32) -> Corner {
    let at = 2.0 * vec2(f32(corner & 1u), f32(corner >> 1u));
    return Corner(vec4(2.0 * at.x - 1.0, 1.0 - 2.0 * at.y, 0.0, 1.0), at);
}

fn decode(color: vec3<f32>) -> vec3<f32> {
    return select(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92, color < vec3(0.04045));
}

@fragment
fn blit_fragment(in: Corner) -> @location(0) vec4<f32> {
    let color = textureSampleLevel(picture, filtering, in.at, 0.0).rgb;
    if decodes {
        return vec4(decode(color), 1.0);
    }
    return vec4(color, 1.0);
}
