//! Time to reach a given error: our methods compared with other libraries, on three scenes with known ends.
//!
//! All use the generated right-hand side and Jacobian, except heyoka, which takes expressions.

mod compiled;
mod differential_equations;
mod diffsol;
mod entrant;
mod heyoka;
mod lanes;
mod ode_solvers;
mod ours;
mod pendulum;
mod results;
mod scene;
mod sweep;
mod write;

use std::error::Error;
use std::fs;
use std::path::Path;

pub(crate) use results::{Curve, Point};
use results::{Results, SceneResults};
pub(crate) use sweep::tolerances;
pub(crate) use write::{RANGE, legend, panel};

use crate::machine;

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (out, build) = (root.join("out"), root.join("out/build"));
    fs::create_dir_all(&build)?;
    let (mut header, mut notes) = (machine::describe(), Vec::new());
    header.extend(["ode_solvers", "differential-equations", "diffsol"].map(|name| format!("{name} {}", locked(name))));
    let scenes = scene::scenes()?;
    let mut entrants = ours::entrants();
    entrants.extend(ode_solvers::entrants());
    entrants.extend(differential_equations::entrants());
    entrants.extend(diffsol::entrants());
    entrants.extend(compiled::entrants(root, &build, &mut header, &mut notes)?);
    println!("compiling and timing heyoka");
    let heyoka = heyoka::measure(root, &build, &scenes, &mut header);
    let heyoka = heyoka.unwrap_or_else(|why| {
        notes.push(why);
        Vec::new()
    });
    let mut heyoka = heyoka.into_iter();
    notes.iter().for_each(|note| println!("left out: {note}"));
    let mut results = Results {
        header,
        notes,
        scenes: Vec::new(),
    };
    for scene in &scenes {
        println!("timing {}: {}", scene.name, scene.title);
        let mut alone = sweep::alone(scene, &entrants);
        let mut together = if scene.stiff {
            Vec::new()
        } else {
            sweep::together(scene, &ours::ensembles())
        };
        if let Some([one, batch]) = heyoka.next() {
            alone.push(one);
            together.extend(Some(batch).filter(|_| !scene.stiff));
        }
        results.scenes.push(SceneResults {
            name: scene.name,
            title: scene.title,
            alone,
            together,
        });
    }
    for path in write::all(&results, &out.join("methods"))? {
        println!("{}", path.display());
    }
    Ok(())
}

/// Version of a crate in the lock file of this program.
pub(crate) fn locked(name: &str) -> &'static str {
    let lock = include_str!("../../Cargo.lock");
    let entry = lock
        .split("[[package]]")
        .find(|entry| entry.contains(&format!("name = \"{name}\"\n")));
    let version = entry.and_then(|entry| entry.split("version = \"").nth(1)?.split('"').next());
    version.unwrap_or("of no known version")
}
