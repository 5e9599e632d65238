//! A finished picture.

use std::io;
use std::path::Path;

/// Rows of red, green and blue bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Three bytes a pixel.
    pub pixels: Vec<u8>,
}

impl Image {
    /// Writes the picture as a PNG file.
    ///
    /// # Errors
    /// The file cannot be written; the message names it.
    pub fn save(&self, path: &Path) -> io::Result<()> {
        self.write(path).map_err(|error| naming(path, error))
    }

    fn write(&self, path: &Path) -> io::Result<()> {
        self.encode(io::BufWriter::new(std::fs::File::create(path)?))
    }

    /// Writes the bytes of a PNG file.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn encode(&self, writer: impl io::Write) -> io::Result<()> {
        let mut encoder = png::Encoder::new(writer, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.pixels)?;
        writer.finish()?;
        Ok(())
    }

    /// Reads a PNG file of red, green and blue bytes.
    ///
    /// # Errors
    /// The file cannot be read, or holds another kind of picture.
    pub fn load(path: &Path) -> io::Result<Self> {
        let file = io::BufReader::new(std::fs::File::open(path)?);
        let mut reader = png::Decoder::new(file).read_info()?;
        let size = reader.output_buffer_size().unwrap_or(0);
        let mut pixels = vec![0; size];
        let info = reader.next_frame(&mut pixels)?;
        if info.color_type != png::ColorType::Rgb || info.bit_depth != png::BitDepth::Eight {
            return Err(io::Error::new(io::ErrorKind::InvalidData, "not a picture of 24 bits"));
        }
        Ok(Self { width: info.width as usize, height: info.height as usize, pixels })
    }

    /// The picture at half the width and height.
    pub fn halved(&self) -> Self {
        let (width, height) = (self.width / 2, self.height / 2);
        let mut pixels = Vec::with_capacity(3 * width * height);
        for y in 0..height {
            for x in 0..width {
                for channel in 0..3 {
                    let at = |dx: usize, dy: usize| {
                        let index = ((2 * y + dy) * self.width + 2 * x + dx) * 3 + channel;
                        u16::from(self.pixels[index])
                    };
                    pixels.push(((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4) as u8);
                }
            }
        }
        Self { width, height, pixels }
    }
}

/// The same error, with the path of the file.
pub fn naming(path: &Path, error: io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_saved_picture_loads() {
        let pixels = (0..3 * 4 * 6).map(|i| i as u8).collect();
        let image = Image { width: 4, height: 6, pixels };
        let path = std::env::temp_dir().join(format!("picture-{}.png", std::process::id()));
        image.save(&path).unwrap();
        assert_eq!(Image::load(&path).unwrap(), image);
        std::fs::remove_file(&path).unwrap();
        assert_eq!(image.halved().pixels.len(), 3 * 2 * 3);
    }
}
