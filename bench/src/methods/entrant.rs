//! One method of one library.

use std::hint::black_box;

use super::scene::Scene;

/// Who integrates, how, and where it is worth a look.
pub(crate) struct Entrant {
    pub by: &'static str,
    pub method: &'static str,
    pub scenes: Scenes,
    /// Integrates a scene so many times with a tolerance, relative and absolute, and says how the last one ended.
    pub integrate: Box<Integrate>,
}

pub(crate) type Integrate = dyn Fn(&Scene, f64, usize) -> Result<End, String>;

/// The library that all others are compared with.
pub(crate) const OURS: &str = "ours";

/// Which scenes a method is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scenes {
    /// Those without stiffness.
    Smooth,
    /// The stiff one.
    Stiff,
    /// All, as of methods that choose, or that show what stiffness costs.
    All,
}

/// Where an integration ended.
pub(crate) struct End {
    pub t: f64,
    pub x: [f64; 4],
    /// Of the right-hand side, where the library tells.
    pub evaluations: Option<usize>,
}

impl Entrant {
    /// From a function that integrates once.
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
