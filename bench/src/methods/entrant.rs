//! One method of one library.

use std::hint::black_box;

use super::scene::Scene;

/// Method of a library, with the scenes for which it is measured.
pub(crate) struct Entrant {
    pub by: &'static str,
    pub method: &'static str,
    pub scenes: Scenes,
    /// Integrates a scene a number of times with a tolerance, relative and absolute, and returns the last end.
    pub integrate: Box<Integrate>,
}

pub(crate) type Integrate = dyn Fn(&Scene, f64, usize) -> Result<End, String>;

/// The library with which all others are compared.
pub(crate) const OURS: &str = "ours";

/// Scenes for which a method is used.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scenes {
    /// The nonstiff scenes.
    Smooth,
    /// The stiff scene.
    Stiff,
    /// All scenes, for methods that detect stiffness or show its cost.
    All,
}

/// End of an integration.
pub(crate) struct End {
    pub t: f64,
    pub x: [f64; 4],
    /// Evaluations of the right-hand side, if the library reports them.
    pub evaluations: Option<usize>,
}

impl Entrant {
    /// Makes an entrant from a function that integrates once.
    pub(crate) fn new(
        by: &'static str,
        method: &'static str,
        scenes: Scenes,
        once: impl Fn(&Scene, f64) -> Result<End, String> + 'static,
    ) -> Self {
        let integrate = move |scene: &Scene, tolerance, times| {
            for _ in 1..times {
                black_box(once(black_box(scene), tolerance)?);
            }
            once(black_box(scene), tolerance)
        };
        Self {
            by,
            method,
            scenes,
            integrate: Box::new(integrate),
        }
    }

    pub(crate) fn suits(&self, scene: &Scene) -> bool {
        match self.scenes {
            Scenes::Smooth => !scene.stiff,
            Scenes::Stiff => scene.stiff,
            Scenes::All => true,
        }
    }
}
