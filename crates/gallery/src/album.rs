//! The page that shows all pictures: `index.html` for a browser, `index.md` for a code host.

use crate::catalog::{Category, Entry};
use crate::runner::Outcome;
use drawing::naming;
use std::fmt::Write as _;
use std::io;
use std::path::Path;

/// The page's file name.
pub(crate) const PAGE: &str = "index.html";
const MARKDOWN_PAGE: &str = "index.md";

/// One scene of the album.
pub(crate) struct Page<'a> {
    pub entry: &'a Entry,
    /// File name of the picture.
    pub file: String,
    /// File name of the moving picture, if there is one.
    pub recording: Option<String>,
    pub outcome: Outcome,
}

/// Creates the folder. An error contains its path.
pub(crate) fn create_folder(folder: &Path) -> io::Result<()> {
    std::fs::create_dir_all(folder).map_err(|error| naming(folder, error))
}

/// Writes both pages.
pub(crate) fn write(folder: &Path, title: &str, pages: &[Page]) -> io::Result<()> {
    for (name, text) in [(PAGE, html(title, pages)), (MARKDOWN_PAGE, markdown(title, pages))] {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(|error| naming(&path, error))?;
    }
    Ok(())
}

/// The figures below a picture.
fn figures(page: &Page) -> String {
    let Outcome { steps, stats, .. } = &page.outcome;
    format!(
        "{} bodies · {} contacts · {steps} steps at {} a second",
        stats.bodies,
        stats.contacts,
        page.outcome.rate()
    )
}

/// The pages of one category, or nothing if there are none.
fn sections<'a>(pages: &'a [Page<'a>]) -> impl Iterator<Item = (&'static str, Vec<&'a Page<'a>>)> {
    Category::ALL.into_iter().filter_map(move |category| {
        let pages: Vec<_> = pages.iter().filter(|page| page.entry.category == category).collect();
        (!pages.is_empty()).then_some((category.heading(), pages))
    })
}

const STYLE: &str = "\
body{margin:0;padding:2rem;background:#0b0e14;color:#c9d3e3;font:15px/1.5 system-ui,sans-serif}\
h1,h2{font-weight:500;letter-spacing:.02em}h2{color:#7f8ca3;margin-top:2.5rem}\
main{display:grid;gap:1.5rem;grid-template-columns:repeat(auto-fill,minmax(min(26rem,100%),1fr))}\
figure{margin:0;background:#121722;border-radius:10px;overflow:hidden}\
img{display:block;width:100%;height:auto}\
figcaption{padding:.8rem 1rem 1rem}b{color:#fff;font-weight:600}\
small{display:block;color:#7f8ca3}";

fn html(title: &str, pages: &[Page]) -> String {
    let mut text = format!(
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n<h1>{title}</h1>\n"
    );
    for (heading, pages) in sections(pages) {
        let _ = writeln!(text, "<h2>{heading}</h2>\n<main>");
        for page in pages {
            let (name, file) = (page.entry.name, &page.file);
            let shown = page.recording.as_ref().unwrap_or(file);
            let _ = writeln!(
                text,
                "<figure><a href=\"{file}\"><img src=\"{shown}\" alt=\"{name}\" loading=\"lazy\"></a>\
                 <figcaption><b>{name}</b> {}<small>{}</small></figcaption></figure>",
                escaped(page.entry.description),
                figures(page)
            );
        }
        text.push_str("</main>\n");
    }
    text.push_str("</html>\n");
    text
}

/// Returns the text with HTML's special characters escaped.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn markdown(title: &str, pages: &[Page]) -> String {
    let mut text = format!("# {title}\n");
    for (heading, pages) in sections(pages) {
        let _ = writeln!(text, "\n## {heading}");
        for page in pages {
            let name = page.entry.name;
            let _ = writeln!(
                text,
                "\n### {name}\n\n{}\n\n![{name}]({})\n\n{}",
                page.entry.description,
                page.file,
                figures(page)
            );
        }
    }
    text
}
