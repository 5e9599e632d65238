//! Colours in sRGB, and their linear light.

/// A colour in sRGB, each part from 0 to 1.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Color {
    /// Red.
    pub red: f32,
    /// Green.
    pub green: f32,
    /// Blue.
    pub blue: f32,
    /// 1 is opaque, 0 is invisible.
    pub opacity: f32,
}

impl Color {
    /// A colour by hue (degrees, any number of turns), saturation, lightness and opacity (0 to 1).
    pub fn from_hsl(hue: f32, saturation: f32, lightness: f32, opacity: f32) -> Self {
        let reach = saturation * lightness.min(1.0 - lightness);
        let channel = |offset: f32| {
            let k = (offset + hue / 30.0).rem_euclid(12.0);
            lightness - reach * (k - 3.0).min(9.0 - k).clamp(-1.0, 1.0)
        };
        Self { red: channel(0.0), green: channel(8.0), blue: channel(4.0), opacity }
    }

    /// The amounts of red, green and blue light.
    pub fn to_light(self) -> [f32; 3] {
        [self.red, self.green, self.blue].map(decode)
    }
}

/// Returns the amount of light of an sRGB value.
fn decode(value: f32) -> f32 {
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// Returns the sRGB byte of an amount of light.
pub(crate) fn encode(light: f32) -> u8 {
    let light = light.clamp(0.0, 1.0);
    let value =
        if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    (value * 255.0 + 0.5) as u8
}

/// Returns the amount of light of an sRGB byte.
pub(crate) fn decode_byte(value: u8) -> f32 {
    decode(f32::from(value) / 255.0)
}
