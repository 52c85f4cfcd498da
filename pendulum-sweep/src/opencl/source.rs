//! Source text of kernels: a scene, a tableau, and the steps of a method.

use std::fmt::Write;

use pendulum_core::Reason;
use pendulum_core::method::{Adaptive, Explicit, Fixed};
use pendulum_core::real::Float;
use pendulum_core::tableau::{ButcherTableau, Tableau};

/// Method whose steps kernels can take: an explicit Runge-Kutta method, with fixed or adaptive steps.
pub trait KernelMethod {
    /// Returns its tableau as OpenCL C.
    #[doc(hidden)]
    fn tableau(&self) -> String;

    /// Returns its settings from `t0` to `t1`.
    #[doc(hidden)]
    fn settings<T: Float>(&self, span: (T, T)) -> Result<Settings<T>, Reason>;
}

/// Settings of an integration, passed to a kernel.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Settings<T> {
    pub h: T,
    pub rtol: T,
    pub atol: T,
    pub h_min: T,
    pub h_max: T,
    pub max_steps: u64,
}

impl<B: Tableau<STAGES>, const STAGES: usize> KernelMethod for Fixed<Explicit<B, STAGES>> {
    fn tableau(&self) -> String {
        stages(&B::TABLEAU)
    }

    fn settings<T: Float>(&self, _span: (T, T)) -> Result<Settings<T>, Reason> {
        let none = T::default();
        Ok(Settings {
            h: T::from_f64(self.h()),
            rtol: none,
            atol: none,
            h_min: none,
            h_max: none,
            max_steps: 0,
        })
    }
}

impl<B: Tableau<STAGES>, const STAGES: usize> KernelMethod for Adaptive<Explicit<B, STAGES>> {
    fn tableau(&self) -> String {
        let tableau = &B::TABLEAU;
        let alpha = 1.0 / (tableau.order_hat as f64 + 1.0) - 0.75 * 0.04;
        format!(
            "#define ERROR_ORDER {}\n#define ALPHA {alpha:?}\n{}{}",
            tableau.order_hat,
            stages(tableau),
            error(tableau)
        )
    }

    fn settings<T: Float>(&self, span: (T, T)) -> Result<Settings<T>, Reason> {
        let control = self.step_control::<T>(B::TABLEAU.order_hat, span)?;
        Ok(Settings {
            h: T::default(),
            rtol: control.tolerance.rtol,
            atol: control.tolerance.atol,
            h_min: control.h_min,
            h_max: control.h_max,
            max_steps: control.max_steps as u64,
        })
    }
}

/// Code of the derivatives at all stages but the first, which is given, and the last, and of the state at the end of a
/// step.
fn stages<const STAGES: usize>(tableau: &ButcherTableau<STAGES>) -> String {
    let rows = (1..STAGES - 1).map(|i| {
        let time = match tableau.c[i] {
            1.0 => "t_new".to_owned(),
            c => format!("t + h * (pendulum_real){c:?}"),
        };
        let sum = weighted("h", "at[c] = x[c] + ", &tableau.a[i]);
        format!("    {{\n{sum}        scene_rhs(model, {time}, at, k[{i}]);\n    }}\n")
    });
    let rows: String = rows.collect();
    let end = weighted("h", "x_new[c] = x[c] + ", &tableau.b);
    format!(
        "#define STAGES {STAGES}\n
static void stages(const scene_model *model, pendulum_real t, pendulum_real t_new, const pendulum_real x[SCENE_LENGTH],
                   pendulum_real k[STAGES][SCENE_LENGTH], pendulum_real x_new[SCENE_LENGTH]) {{
    const pendulum_real h = t_new - t;
    pendulum_real at[SCENE_LENGTH];
{rows}    {{\n{end}    }}\n}}\n"
    )
}

/// Code of the estimated error of a step.
fn error<const STAGES: usize>(tableau: &ButcherTableau<STAGES>) -> String {
    let sum = weighted("h", "error[c] = ", &tableau.error_weights());
    format!(
        "
static void error_of(pendulum_real h, pendulum_real k[STAGES][SCENE_LENGTH], pendulum_real error[SCENE_LENGTH]) {{
{sum}}}\n"
    )
}

/// Code of sums over stages with the weights `h w_i`, added from left to right like in Rust.
fn weighted(h: &str, target: &str, weights: &[f64]) -> String {
    let used: Vec<usize> = (0..weights.len()).filter(|&i| weights[i] != 0.0).collect();
    let mut text = String::new();
    for &i in &used {
        let _ = writeln!(
            text,
            "        const pendulum_real w{i} = {h} * (pendulum_real){:?};",
            weights[i]
        );
    }
    let terms: Vec<String> = used.iter().map(|i| format!("w{i} * k[{i}][c]")).collect();
    let _ = writeln!(
        text,
        "        for (int c = 0; c < SCENE_LENGTH; c++) {target}({});",
        terms.join(" + ")
    );
    text
}

/// Returns the whole program.
pub(super) fn program(scene: &str, method: &impl KernelMethod) -> String {
    [scene, &method.tableau(), include_str!("integrate.cl")].join("\n")
}
