//! Gallery page of the book.

use std::fmt::Write;

use crate::{SYSTEMS, System};

/// Formats the page: for each system its text, its picture and its declarations.
pub fn page() -> String {
    let mut page = String::from(
        "# Gallery\n\n\
        Mechanisms of the paper (H. Williams, Forces in Mechanics 2023), of its references, and beyond. `cargo run \
         --release -p\ngallery` checks each of them and draws it into `out/gallery/`; `--animate` makes GIFs as well. \
         Each name leads to its\nfile, with the checks.\n",
    );
    for system in SYSTEMS {
        let (title, text) = system.text();
        let name = system.name;
        write!(
            page,
            "\n## [{title}](../../examples/gallery/src/{name}.rs)\n\n{text}\n\n![{title}](img/gallery/{name}.png)\n"
        )
        .expect("memory");
        for declaration in system.declarations() {
            write!(page, "\n```rust,ignore\n{declaration}\n```\n").expect("memory");
        }
    }
    page
}

impl System {
    /// Title and text of the file.
    fn text(&self) -> (&'static str, String) {
        let mut lines = self.source.lines().map_while(|line| line.strip_prefix("//!"));
        let title = lines.next().map_or("", |line| line.trim_start_matches([' ', '#']));
        let text: Vec<&str> = lines.map(str::trim).skip_while(|line| line.is_empty()).collect();
        (title, text.join("\n"))
    }

    /// Source text of its declarations.
    pub fn declarations(&self) -> Vec<&'static str> {
        let starts = self
            .source
            .match_indices("mechanism! {")
            .map(|(start, _)| &self.source[start..]);
        let whole = |text: &'static str| text.find("\n}").map_or(text, |end| &text[..end + 2]);
        starts.map(whole).collect()
    }
}
