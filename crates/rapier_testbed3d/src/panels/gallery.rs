//! The list of scenes: search, categories, pictures.

use crate::session::Demo;
use crate::thumbnails::{SIZE, Thumbnails};
use eframe::egui::{self, Color32, RichText, Sense, Ui, Vec2};
use gallery::Category;

/// Width of a picture in the list, in points.
const WIDTH: f32 = 84.0;

/// The state of the list.
#[derive(Default)]
pub(crate) struct GalleryPanel {
    pub search: String,
    category: Option<Category>,
}

impl GalleryPanel {
    /// Shows the list; returns the scene that was clicked.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        demos: &[Demo],
        current: usize,
        thumbnails: &mut Thumbnails,
    ) -> Option<usize> {
        ui.add_space(6.0);
        let hint = match demos.len() {
            1 => "Search one scene".to_owned(),
            count => format!("Search {count} scenes"),
        };
        ui.add(
            egui::TextEdit::singleline(&mut self.search)
                .hint_text(hint)
                .desired_width(f32::INFINITY),
        );
        self.choose_category(ui, demos);
        ui.separator();
        let mut clicked = None;
        egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            for category in Category::ALL {
                let wanted: Vec<usize> =
                    (0..demos.len()).filter(|&i| self.lists(&demos[i], category)).collect();
                if wanted.is_empty() {
                    continue;
                }
                ui.add_space(4.0);
                ui.label(RichText::new(category.heading()).strong().color(Color32::from_gray(150)));
                for index in wanted {
                    if row(ui, &demos[index], index == current, thumbnails) {
                        clicked = Some(index);
                    }
                }
            }
        });
        clicked
    }

    fn choose_category(&mut self, ui: &mut Ui, demos: &[Demo]) {
        let title = self.category.map_or("All categories", Category::heading);
        egui::ComboBox::from_id_salt("category")
            .selected_text(title)
            .width(ui.available_width())
            .show_ui(ui, |ui| {
                ui.selectable_value(&mut self.category, None, "All categories");
                for category in Category::ALL {
                    if demos.iter().any(|demo| demo.category == category) {
                        ui.selectable_value(&mut self.category, Some(category), category.heading());
                    }
                }
            });
    }

    fn lists(&self, demo: &Demo, category: Category) -> bool {
        let chosen = self.category.is_none_or(|chosen| chosen == category);
        let text = format!("{} {}", title_of(&demo.name), demo.description).to_lowercase();
        let matches = self.search.to_lowercase().split_whitespace().all(|word| text.contains(word));
        demo.category == category && chosen && matches
    }
}

/// The name of a scene as a title.
pub(crate) fn title_of(name: &str) -> String {
    name.replace('_', " ")
}

/// Shows a scene of the list; returns whether it was clicked.
fn row(ui: &mut Ui, demo: &Demo, current: bool, thumbnails: &mut Thumbnails) -> bool {
    let picture = Vec2::new(WIDTH, WIDTH * SIZE[1] as f32 / SIZE[0] as f32);
    let size = Vec2::new(ui.available_width(), picture.y + 6.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    if !ui.is_rect_visible(rect) {
        return false;
    }
    let fill = match (current, response.hovered()) {
        (true, _) => Color32::from_rgb(44, 66, 98),
        (false, true) => Color32::from_gray(48),
        _ => Color32::TRANSPARENT,
    };
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, fill);
    let place = egui::Rect::from_min_size(rect.left_top() + Vec2::splat(3.0), picture);
    painter.rect_filled(place, 3.0, Color32::from_gray(36));
    if let Some(texture) = thumbnails.get(ui.ctx(), &demo.name, &demo.build) {
        let whole = egui::Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
        painter.image(texture.id(), place, whole, Color32::WHITE);
    }
    let text = egui::Rect::from_min_max(
        egui::pos2(place.right() + 8.0, rect.top()),
        egui::pos2(rect.right() - 2.0, rect.bottom()),
    );
    let color = if current { Color32::WHITE } else { Color32::from_gray(205) };
    let font = egui::FontId::proportional(14.0);
    let galley = painter.layout(title_of(&demo.name), font, color, text.width());
    let top = text.center().y - 0.5 * galley.size().y;
    painter.galley(egui::pos2(text.left(), top), galley, color);
    response.on_hover_text(&demo.description).clicked()
}
