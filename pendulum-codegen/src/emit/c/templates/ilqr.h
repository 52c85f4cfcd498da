
/// Number of steps of a plan.
#define @NAME@_ILQR_STEPS @steps@

/// Length of a step in s.
#define @NAME@_ILQR_H @h@

/// Planned motion: states and inputs at the start of each step, and the state at the end.
typedef struct {
    double x[@NAME@_ILQR_STEPS][@NAME@_STATES], end[@NAME@_STATES], u[@NAME@_ILQR_STEPS][@NAME@_INPUTS];
} @name@_ilqr_plan;

/// Iterative LQR, as `Ilqr` with the cost `Quadratic`: a plan and its gains. It takes no other memory but some of the stack.
typedef struct {
    /// The best motion.
    @name@_ilqr_plan plan;
    /// The motion of the last forward pass, along which the backward pass goes.
    @name@_ilqr_plan trial;
    /// Change of the inputs by the last backward pass; 0 once it is in the plan.
    double change[@NAME@_ILQR_STEPS][@NAME@_INPUTS];
    /// Gain at each step: one row for each input.
    double gain[@NAME@_ILQR_STEPS][@NAME@_INPUTS][@NAME@_STATES];
    /// Damping of the search, and the factor by which it changed last.
    double damping, factor;
    /// Cost of the plan after the last pass, and before it.
    double cost, cost_before;
    /// Share of the change of the inputs that the last pass took: 1, a half, and so on; 0 if none decreases the cost.
    double share;
    /// Time of the start of the plan, once is_sampled is 1: after the first sample.
    double t;
    int is_sampled;
} @name@_ilqr;

/// Return values of @name@_ilqr_pass and @name@_ilqr_sample.
enum {
    @NAME@_ILQR_OK = 0,
    /// The state or the time is not finite.
    @NAME@_ILQR_NOT_FINITE = 1,
    /// The plan leaves the range of numbers.
    @NAME@_ILQR_DIVERGED = 2,
    /// The cost is not convex in the inputs of a step.
    @NAME@_ILQR_NOT_CONVEX = 3
};

/// Begins with the planned inputs that were given to the generator, without gains.
void @name@_ilqr_start(@name@_ilqr *ilqr);

/// Improves the plan by one backward and one forward pass from the state x0 at t0: `Ilqr::pass`.
///
/// Returns 0, or the reason why the plan stays as it was. If that is @NAME@_ILQR_NOT_CONVEX, the gains of some steps at its end are new.
int @name@_ilqr_pass(@name@_ilqr *ilqr, const @name@_model *model, double t0, const double x0[@length@]);

/// Moves the plan on by a step: the last inputs and gains are repeated.
void @name@_ilqr_shift(@name@_ilqr *ilqr);

/// The inputs that the law of a step commands in the state x, within their limits: `Ilqr::command`.
///
/// step: from 0 to @NAME@_ILQR_STEPS - 1, which is not checked. All inputs are NaN if a component of x is NaN.
void @name@_ilqr_command(const @name@_ilqr *ilqr, int step, const double x[@length@], @name@_inputs *u);

/// A sample of model-predictive control, `Ilqr::controller`: moves the plan on with the time, takes a pass, and commands the first
/// inputs.
///
/// Returns 0, or the reason why the inputs stay as they were. If that is @NAME@_ILQR_NOT_FINITE, all of ilqr does, too.
int @name@_ilqr_sample(@name@_ilqr *ilqr, const @name@_model *model, double t, const double x[@length@], @name@_inputs *u);
