// The light of surfaces, lines, and the shadow map. The numbers stand in `drawing::light`.

struct View {
    matrix: mat4x4<f32>,
    sun_matrix: mat4x4<f32>,
    eye: vec4<f32>,         // w: 1 if the view is flat
    center: vec4<f32>,      // w: radius of the content
    sun: vec4<f32>,         // w: side of a texel of the shadow map, in world units; 0 without shadows
    sun_light: vec4<f32>,   // w: light of a highlighted surface
    sky_light: vec4<f32>,   // w: strength of highlights
    ground_light: vec4<f32>,// w: haze
    top: vec4<f32>,         // background
    bottom: vec4<f32>,      // background; w: cell of the grid
    depth: vec4<f32>,       // nearest and farthest content; size of a pixel at distance 1; width of a rim
    size: vec4<f32>,        // width and height of the picture; light of a rim; light of a flat inside
};

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var shadow_map: texture_depth_2d;
@group(0) @binding(2) var shadow_sampler: sampler_comparison;

// Taps of the shadow map for a pixel: 1 or 4. A constant, because adapters in software execute both sides of a branch.
override taps: u32 = 4;

const GROUND: u32 = 1u;
const HIGHLIGHTED: u32 = 2u;

struct Instance {
    @location(2) position: vec3<f32>,
    @location(3) rotation: vec4<f32>,
    @location(4) scale: vec3<f32>,
    @location(5) color: vec4<f32>,
    @location(6) flags: u32,
};

fn rotate(q: vec4<f32>, v: vec3<f32>) -> vec3<f32> {
    let t = 2.0 * cross(q.xyz, v);
    return v + q.w * t + cross(q.xyz, t);
}

struct Surface {
    @builtin(position) clip: vec4<f32>,
    @location(0) place: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) @interpolate(flat) color: vec4<f32>,
    @location(3) @interpolate(flat) flags: u32,
};

@vertex
fn surface_vertex(@location(0) position: vec3<f32>, @location(1) normal: vec3<f32>, instance: Instance) -> Surface {
    var out: Surface;
    out.place = instance.position + rotate(instance.rotation, position * instance.scale);
    out.normal = rotate(instance.rotation, normal / instance.scale);
    if view.eye.w > 0.5 {
        let inside = normal.z > 0.5;
        if !inside {
            out.place += rotate(instance.rotation, normal) * view.depth.w;
        }
        out.normal = vec3(0.0, 0.0, select(0.0, 1.0, inside));
    }
    out.clip = view.matrix * vec4(out.place, 1.0);
    out.color = instance.color;
    out.flags = instance.flags;
    return out;
}

@vertex
fn shadow_vertex(@location(0) position: vec3<f32>, instance: Instance) -> @builtin(position) vec4<f32> {
    let place = instance.position + rotate(instance.rotation, position * instance.scale);
    if (instance.flags & GROUND) != 0u {
        return vec4(2.0, 2.0, 2.0, 1.0);
    }
    return view.sun_matrix * vec4(place, 1.0);
}

// Fraction of the sun's light at a point.
fn sunlight(place: vec3<f32>, normal: vec3<f32>) -> f32 {
    let texel = view.sun.w;
    if texel == 0.0 {
        return 1.0;
    }
    let raised = place + (normal + view.sun.xyz) * (1.6 * texel);
    let seen = view.sun_matrix * vec4(raised, 1.0);
    let at = vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y);
    if any(at < vec2(0.001)) || any(at > vec2(0.999)) {
        return 1.0;
    }
    if taps == 1u {
        return textureSampleCompareLevel(shadow_map, shadow_sampler, at, seen.z);
    }
    // Four taps of two by two texels, half a texel apart.
    let step = 0.5 / f32(textureDimensions(shadow_map).x);
    var lit = 0.0;
    lit += textureSampleCompareLevel(shadow_map, shadow_sampler, at + vec2(-step, -step), seen.z);
    lit += textureSampleCompareLevel(shadow_map, shadow_sampler, at + vec2(step, -step), seen.z);
    lit += textureSampleCompareLevel(shadow_map, shadow_sampler, at + vec2(-step, step), seen.z);
    lit += textureSampleCompareLevel(shadow_map, shadow_sampler, at + vec2(step, step), seen.z);
    return 0.25 * lit;
}

fn background(y: f32) -> vec3<f32> {
    return mix(view.top.rgb, view.bottom.rgb, y / view.size.y);
}

// The sRGB values that stand for amounts of light, to 0.3 of a level: roots are faster than powers.
fn encode(light: vec3<f32>) -> vec3<f32> {
    let l = clamp(light, vec3(0.0), vec3(1.0));
    let root2 = sqrt(l);
    let root4 = sqrt(root2);
    let root8 = sqrt(root4);
    let curve = 0.662002687 * root2 + 0.684122060 * root4 - 0.323583601 * root8 - 0.0225411470 * l;
    return max(curve, vec3(0.0));
}

fn power32(x: f32) -> f32 {
    let x2 = x * x;
    let x4 = x2 * x2;
    let x8 = x4 * x4;
    return x8 * x8 * x8 * x8;
}

fn grid_line(position: f32, cell: f32, pixel: f32) -> f32 {
    let distance = abs(fract(position / cell + 0.5) - 0.5) * cell;
    let crowded = smoothstep(3.0, 14.0, cell / pixel);
    return clamp(1.0 - distance / (0.9 * pixel), 0.0, 1.0) * crowded;
}

// Opacity of the ground, and how much of a grid line there is.
fn ground(place: vec3<f32>, w: f32) -> vec2<f32> {
    let distance = length(place.xz - view.center.xz);
    let fade = 1.0 - smoothstep(1.6 * view.center.w, 6.0 * view.center.w, distance);
    let cell = view.bottom.w;
    let pixel = view.depth.z * w;
    let fine = max(grid_line(place.x, cell, pixel), grid_line(place.z, cell, pixel));
    let coarse = max(grid_line(place.x, 5.0 * cell, pixel), grid_line(place.z, 5.0 * cell, pixel));
    return vec2(fade, max(0.4 * fine, coarse));
}

@fragment
fn surface_fragment(in: Surface, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    let highlight = select(0.0, view.sun_light.w, (in.flags & HIGHLIGHTED) != 0u);
    if view.eye.w > 0.5 {
        return vec4(encode(in.color.rgb * mix(view.size.z, view.size.w, in.normal.z) + highlight), in.color.a);
    }
    let to_eye_long = view.eye.xyz - in.place;
    let to_eye = normalize(to_eye_long);
    var normal = normalize(in.normal);
    let distance = 1.0 / in.clip.w;
    var opacity = in.color.a;
    var albedo = in.color.rgb;
    if (in.flags & GROUND) != 0u {
        if dot(normal, to_eye) < 0.0 {
            discard;
        }
        let look = ground(in.place, distance);
        opacity *= look.x;
        albedo *= 1.0 + 0.55 * look.y;
    }
    if dot(normal, to_eye) < 0.0 {
        normal = -normal;
    }
    let facing = max(dot(normal, view.sun.xyz), 0.0);
    var reach = 1.0;
    if facing > 0.0 {
        reach = sunlight(in.place, normal);
    }
    let middle = normalize(view.sun.xyz + to_eye);
    let gloss = view.sky_light.w * power32(max(dot(normal, middle), 0.0)) * facing;
    let around = mix(view.ground_light.rgb, view.sky_light.rgb, 0.5 + 0.5 * normal.y);
    var light = albedo * (around + view.sun_light.rgb * facing * reach) + gloss * reach;
    let haze = view.ground_light.w * smoothstep(view.depth.x, 1.6 * view.depth.y, distance);
    light = mix(light, background(in.clip.y), haze) + highlight;
    return vec4(encode(light), opacity);
}

struct Stroke {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(flat) color: vec4<f32>,
    @location(1) across: f32,
};

// A line: a band of the width of two pixels, as a strip of four corners.
@vertex
fn line_vertex(
    @builtin(vertex_index) corner: u32,
    @location(0) from_place: vec3<f32>,
    @location(1) to_place: vec3<f32>,
    @location(2) color: vec4<f32>,
    @location(3) on_top: f32,
) -> Stroke {
    var a = view.matrix * vec4(from_place, 1.0);
    var b = view.matrix * vec4(to_place, 1.0);
    // Cut the line where it passes the eye.
    let nearest = select(1.0e-3, 0.02 * view.depth.x, view.eye.w < 0.5);
    if a.w < nearest {
        a = mix(a, b, (nearest - a.w) / max(b.w - a.w, 1.0e-6));
    }
    if b.w < nearest {
        b = mix(b, a, (nearest - b.w) / max(a.w - b.w, 1.0e-6));
    }
    let half_size = 0.5 * view.size.xy;
    let direction = (b.xy / b.w - a.xy / a.w) * half_size;
    let along = direction / max(length(direction), 1.0e-6);
    let width = (0.5 + mix(0.7, 1.1, on_top)) * view.size.y / 720.0;
    let side = f32(corner & 1u) * 2.0 - 1.0;
    var p = select(a, b, corner >= 2u);
    let offset = vec2(-along.y, along.x) * side * width + along * select(-0.5, 0.5, corner >= 2u);
    p += vec4(offset / half_size * p.w, 0.0, 0.0);
    // A little nearer than it is, so that the faces along it do not hide it; on top, before everything.
    p.z = select(p.z * 1.0025, 0.999 * p.w, on_top > 0.5);
    if view.eye.w > 0.5 {
        // Lines of flat scenes lie below the shapes, whose depth is 0.5, or on top.
        p.z = select(0.4, 0.6, on_top > 0.5) * p.w;
    }
    var out: Stroke;
    out.clip = p;
    out.color = color;
    out.across = side * width;
    return out;
}

@fragment
fn line_fragment(in: Stroke) -> @location(0) vec4<f32> {
    return vec4(encode(in.color.rgb), in.color.a);
}

struct Sky {
    @builtin(position) clip: vec4<f32>,
};

@vertex
fn sky_vertex(@builtin(vertex_index) corner: u32) -> Sky {
    var out: Sky;
    let x = f32(corner & 1u) * 4.0 - 1.0;
    let y = f32(corner >> 1u) * 4.0 - 1.0;
    out.clip = vec4(x, y, 0.0, 1.0);
    return out;
}

@fragment
fn sky_fragment(in: Sky) -> @location(0) vec4<f32> {
    return vec4(encode(background(in.clip.y)), 1.0);
}
