//! Sizes of a scene.

use crate::model::Model;

/// Length that depends on the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Length {
    /// Number of components of the state.
    State,
    /// Number of degrees of freedom.
    Freedom,
    /// Number of inputs.
    Inputs,
    /// Number of parameters.
    Parameters,
    /// Number of driven joints.
    Drives,
    /// Number of constraints.
    Constraints,
    /// Number of closed loops.
    Loops,
    /// Number of closed loops without a closed form.
    Gaps,
    /// Number of angles whose turns are not counted although forces depend on them.
    Uncounted,
    /// Number of dependent coordinates in the state.
    Dependents,
    /// Number of components of a wrench.
    Wrench,
}

/// Number of components of a wrench: a moment and a force.
const WRENCH: usize = 6;

/// Sizes of a scene.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counts {
    pub(crate) state: usize,
    pub(crate) freedom: usize,
    pub(crate) inputs: usize,
    pub(crate) parameters: usize,
    pub(crate) drives: usize,
    pub(crate) constraints: usize,
    pub(crate) loops: usize,
    pub(crate) gaps: usize,
    pub(crate) uncounted: usize,
    pub(crate) dependents: usize,
}

impl Counts {
    pub(super) fn of(model: &Model<'_>) -> Self {
        Self {
            state: model.state().len(),
            freedom: model.dof(),
            inputs: model.inputs.len(),
            parameters: model.parameters.len(),
            drives: model.drives.len(),
            constraints: model.constraints.len(),
            loops: model.loops.margins.len(),
            gaps: model.loops.gaps.len(),
            uncounted: model.loops.uncounted.len(),
            dependents: model.loops.corrections.len(),
        }
    }

    pub(super) fn length(&self, of: Length) -> usize {
        match of {
            Length::State => self.state,
            Length::Freedom => self.freedom,
            Length::Inputs => self.inputs,
            Length::Parameters => self.parameters,
            Length::Drives => self.drives,
            Length::Constraints => self.constraints,
            Length::Loops => self.loops,
            Length::Gaps => self.gaps,
            Length::Uncounted => self.uncounted,
            Length::Dependents => self.dependents,
            Length::Wrench => WRENCH,
        }
    }
}
