//! Upper limits of a step: counted operations against the limits that methods promise, and stack.

use pendulum_core::hybrid::{Hold, InMode};
use pendulum_core::method::{Accepted, Fixed, Gauss, OneStep, RadauIIA, Scheme, Tolerance};
use pendulum_core::prelude::*;
use pendulum_core::system::Canonical;
use pendulum_core::taylor::TaylorSeries;
use pendulum_core::{Cost, Operations, Statistics, Step};
use testbed::counted::{Counted, charge, spent};
use testbed::mechanisms::Tree;
use testbed::robots::{Ur5, Ur5Params};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// Operations of the third step.
fn counted<M, S, const N: usize>(method: &M, model: &S) -> Operations
where
    M: Method<S, Counted, N>,
    S: System<Counted, N>,
{
    let mut stepper = method
        .stepper(model, Counted(0.0), Counted(10.0), [Counted(0.3); N])
        .expect("valid");
    stepper.step().and_then(|_| stepper.step()).expect("regular");
    let tried = stepper.statistics().rejected;
    let operations = spent(|| assert!(stepper.step().expect("regular").is_some()));
    assert_eq!(stepper.statistics().rejected, tried, "one try");
    operations
}

fn row(o: Operations) -> [usize; 5] {
    [o.additions, o.multiplications, o.divisions, o.sincos, o.functions]
}

/// Asserts that operations stay within the limit but near it: control in double precision is not counted.
fn assert_most(counted: Operations, most: Operations, what: &str) {
    for (counted, most) in std::iter::zip(row(counted), row(most)) {
        assert!(counted <= most && most <= counted + 40, "{what}: {counted} of {most}");
    }
}

#[test]
fn a_small_stack_is_enough() {
    fn run<M: Method<DoublePendulum, f64, 4>>(method: &M) {
        let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
        let mut stepper = method.stepper(&model, 0.0, 0.1, [0.3; 4]).expect("valid");
        stepper.run().expect("regular");
        std::hint::black_box(stepper.dense().at(0.09));
    }
    macro_rules! each {
        ($kib:literal: $($method:expr),*) => { $(
            // a stack overflow ends the whole program
            let thread = std::thread::Builder::new().stack_size($kib << 10).spawn(|| run(&$method));
            thread.expect("a thread").join().expect(stringify!($method));
        )* };
    }
    each!(64: Rk4::new(0.01), Rk45::new(), Vern9::new(), Rodas5P::new(), Auto::new(), Gauss4::new(0.01));
    each!(256: Taylor::new());
}

#[test]
fn a_step_takes_no_more_than_its_method_says() {
    fn check<S: Jacobian<Counted, N>, const N: usize>(model: &S, cost: &Cost) {
        let [rhs, jacobian] = ["rhs", "jacobian"].map(|name| cost[name].operations);
        macro_rules! each {
            ($($method:ident: $value:expr, ($($cost:ident),*);)*) => { $(
                assert_most(counted(&$value, model), $method::operations($($cost,)* N), stringify!($method));
            )* };
        }
        each! {
            Rk4: Rk4::new(0.01), (rhs);
            Rk45: Rk45::new(), (rhs);
            Tsit5: Tsit5::new(), (rhs);
            Vern7: Vern7::new(), (rhs);
            Vern9: Vern9::new(), (rhs);
            Rodas4: Rodas4::new(), (rhs, jacobian);
            Rodas5P: Rodas5P::new(), (rhs, jacobian);
        }
    }
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    check(&model.cast::<Counted>(), &DoublePendulum::COST);
    let model = Tree::new(Default::default()).expect("physical");
    check(&model.cast::<Counted>(), &Tree::COST);
    let model = Ur5::new(Ur5Params {}).expect("physical");
    check(&model.cast::<Counted>(), &Ur5::COST);
}

#[test]
fn a_power_series_takes_what_its_orders_take() {
    fn check<S: TaylorSeries<Counted, N>, const N: usize>(model: &S, cost: &Cost) {
        let mut work = model.workspace();
        let mut of_order = |order: usize| {
            let mut x = vec![SVector::from([Counted(0.3); N]); order + 1];
            spent(|| model.series(Counted(0.0), &mut x, &mut work))
        };
        let start = of_order(1);
        for order in [2, 3, 4, 5, 24] {
            let (counted, most) = (of_order(order), start.and(cost["taylor"].series(order, N)));
            let mut expected = row(most);
            // the reciprocal of each order is taken in f64, where operations are not counted
            expected[2] -= order - 1;
            assert_eq!(row(counted), expected, "{order}");
        }
    }
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    check(&model.cast::<Counted>(), &DoublePendulum::COST);
    let model = Ur5::new(Ur5Params {}).expect("physical");
    check(&model.cast::<Counted>(), &Ur5::COST);
}

/// Equations `x' = -rate x`, which count as many operations as specified.
struct Charged<const N: usize> {
    rate: f64,
    /// Fraction of the Jacobian returned from the time 1 on: iterations converge more slowly if it is smaller.
    given: f64,
    rhs: Operations,
    jacobian: Operations,
}

const RHS: Operations = Operations::new(1000, 2000, 3000, 4000, 5000, 0);
const JACOBIAN: Operations = Operations::new(70_000, 80_000, 90_000, 60_000, 50_000, 0);

impl<const N: usize> Charged<N> {
    fn new(rate: f64, given: f64) -> Self {
        Self {
            rate,
            given,
            rhs: RHS,
            jacobian: JACOBIAN,
        }
    }

    fn slope(&self, x: &SVector<Counted, N>) -> SVector<Counted, N> {
        x.map(|x| Counted(-self.rate * x.0))
    }

    fn matrix(&self, t: Counted) -> SMatrix<Counted, N, N> {
        let given = if t.0 < 1.0 { 1.0 } else { self.given };
        SMatrix::from_fn(|i, j| Counted(if i == j { -self.rate * given } else { 0.0 }))
    }
}

impl<const N: usize> System<Counted, N> for Charged<N> {
    fn rhs(&self, _t: Counted, x: &SVector<Counted, N>) -> SVector<Counted, N> {
        charge(self.rhs);
        self.slope(x)
    }
}

impl<const N: usize> Jacobian<Counted, N> for Charged<N> {
    fn jacobian(&self, _t: Counted, _x: &SVector<Counted, N>) -> SMatrix<Counted, N, N> {
        unreachable!("no method takes it without the right-hand side")
    }

    fn rhs_and_jacobian(&self, t: Counted, x: &SVector<Counted, N>) -> (SVector<Counted, N>, SMatrix<Counted, N, N>) {
        charge(self.jacobian);
        (self.slope(x), self.matrix(t))
    }

    fn time_derivative(&self, _t: Counted, _x: &SVector<Counted, N>) -> SVector<Counted, N> {
        SVector::from_element(Counted(0.0))
    }
}

/// The state itself serves as canonical variables.
impl<const N: usize> Canonical<Counted, N> for Charged<N> {
    fn canonical(&self, _t: Counted, x: &SVector<Counted, N>) -> (SVector<Counted, N>, SVector<Counted, N>) {
        charge(self.rhs);
        (*x, self.slope(x))
    }

    fn canonical_jacobian(
        &self,
        t: Counted,
        _x: &SVector<Counted, N>,
    ) -> (SMatrix<Counted, N, N>, SMatrix<Counted, N, N>) {
        charge(self.jacobian);
        let of_variables = SMatrix::from_fn(|i, j| Counted(if i == j { 1.0 } else { 0.0 }));
        (of_variables, self.matrix(t))
    }
}

impl<const N: usize> TaylorSeries<Counted, N> for Charged<N> {
    type Workspace = ();

    fn workspace(&self) {}

    fn series(&self, _t: Counted, x: &mut [SVector<Counted, N>], _work: &mut ()) {
        charge(self.jacobian);
        for k in 1..x.len() {
            x[k] = x[k - 1].map(|x| Counted(-self.rate * x.0 / k as f64));
        }
    }
}

/// Operations of the first step up to time 10 whose change of statistics is wanted, if there is one.
fn spent_where<M, S, const N: usize>(
    method: &M,
    model: &S,
    is_wanted: impl Fn(Statistics, Statistics) -> bool,
) -> Option<Operations>
where
    M: Method<S, Counted, N>,
    S: System<Counted, N>,
{
    let mut stepper = method
        .stepper(model, Counted(0.0), Counted(10.0), [Counted(0.3); N])
        .expect("valid");
    for _ in 0..100 {
        let before = stepper.statistics();
        let mut is_step = false;
        let operations = spent(|| is_step = stepper.step().is_ok_and(|step| step.is_some()));
        if !is_step {
            return None;
        }
        let after = stepper.statistics();
        if after.rejected == before.rejected && is_wanted(before, after) {
            return Some(operations);
        }
    }
    None
}

/// Operations of a Radau step with all of its iterations and both error estimates, without its control.
fn spent_by_radau<const N: usize>() -> Option<Operations> {
    let tolerance = Tolerance {
        rtol: Counted(1e-6),
        atol: Counted(1e-9),
    };
    let draws = (1..40).flat_map(|h| (1..60).map(move |given| (0.05 * f64::from(h), 0.02 * f64::from(given))));
    draws.into_iter().find_map(|(h, given)| {
        let model = Charged::<N>::new(1.0, given);
        let mut scheme = OneStep::<_, Counted, N>::scheme(&RadauIIA::<3, 1>, &model, Some(tolerance)).expect("valid");
        let hold = Hold::default();
        let mode = InMode::new(&model, &hold);
        let mut work = Statistics::default();
        let (t0, t1, t2) = (Counted(1.0), Counted(1.001), Counted(1.001 + h));
        let x0 = SVector::from([Counted(0.3); N]);
        let (mut x1, mut x2) = (x0, x0);
        scheme.begin(&mode, t0, &x0, &mut work);
        scheme.attempt(&mode, (t0, &x0), (t1, &mut x1), &mut work).ok()?;
        scheme.arrive(&mode, (t1, &x1), &mut work);
        let step = Step {
            t0,
            t1,
            h: t1 - t0,
            x0,
            x1,
        };
        scheme.accept(&mode, &step, Accepted::All, &mut work);
        // after one attempt, the next one also computes the second error estimate; at another length, a new matrix
        let longer = t2 + Counted(0.01);
        scheme.attempt(&mode, (t1, &x1), (longer, &mut x2), &mut work).ok()?;
        let before = work;
        let mut arrived = false;
        let operations = spent(|| {
            arrived = scheme.attempt(&mode, (t1, &x1), (t2, &mut x2), &mut work).is_ok();
            scheme.arrive(&mode, (t2, &x2), &mut work);
            scheme.accept(&mode, &step, Accepted::All, &mut work);
        });
        // with the second error estimate and the derivative at the end
        let is_most = work.iterations == before.iterations + 7 && work.evaluations == before.evaluations + 7 * 3 + 2;
        (arrived && is_most).then_some(operations)
    })
}

/// Excess of the promised operations over the counted ones, which must be the same for systems of all sizes.
fn excess(what: &str, of: [(Option<Operations>, Operations); 4]) -> [isize; 5] {
    let of = of.map(|(counted, most)| {
        let counted = row(counted.unwrap_or_else(|| panic!("no such step of {what}")));
        std::array::from_fn(|k| row(most)[k].cast_signed() - counted[k].cast_signed())
    });
    assert_eq!(of, [of[0]; 4], "{what}: it grows with the size of the system");
    of[0]
}

macro_rules! excess {
    ($what:literal, $n:ident => $counted:expr, $most:expr) => {
        excess(
            $what,
            [
                {
                    const $n: usize = 1;
                    ($counted, $most)
                },
                {
                    const $n: usize = 2;
                    ($counted, $most)
                },
                {
                    const $n: usize = 5;
                    ($counted, $most)
                },
                {
                    const $n: usize = 8;
                    ($counted, $most)
                },
            ],
        )
    };
}

/// Counts are those of the code except for control in double precision and work that some steps skip. These do not grow
/// with the size of a system: each loop over its components is counted to the last operation.
#[test]
fn what_a_step_promises_and_does_not_take_is_the_same_for_all_sizes() {
    let any = |_, _| true;
    let excesses = [
        excess!("Rk4", N => spent_where(&Rk4::new(0.01), &Charged::<N>::new(1.0, 1.0), any), Rk4::operations(RHS, N)),
        excess!("Rk45", N => spent_where(&Rk45::new(), &Charged::<N>::new(1.0, 1.0), any), Rk45::operations(RHS, N)),
        excess!("Vern9", N => spent_where(&Vern9::new(), &Charged::<N>::new(1.0, 1.0), any), Vern9::operations(RHS, N)),
        excess!(
            "Rodas4",
            N => spent_where(&Rodas4::new(), &Charged::<N>::new(1.0, 1.0), any),
            Rodas4::operations(RHS, JACOBIAN, N)
        ),
        excess!(
            "Rodas5P",
            N => spent_where(&Rodas5P::new(), &Charged::<N>::new(1.0, 1.0), any),
            Rodas5P::operations(RHS, JACOBIAN, N)
        ),
        excess!("Radau5", N => spent_by_radau::<N>(), Radau5::operations(RHS, JACOBIAN, N)),
        excess!(
            "Taylor",
            N => spent_where(&Taylor::new().order(13), &Charged::<N>::new(1.0, 1.0), any),
            Taylor::operations(JACOBIAN, 13, N)
        ),
        excess!(
            "Taylor of an even order",
            N => spent_where(&Taylor::new().order(20), &Charged::<N>::new(1.0, 1.0), any),
            Taylor::operations(JACOBIAN, 20, N)
        ),
        excess!("Gauss4", N => spent_by_gauss::<2, 1, N>(), Gauss4::operations(RHS, JACOBIAN, N)),
        excess!("Gauss6", N => spent_by_gauss::<3, 1, N>(), Gauss6::operations(RHS, JACOBIAN, N)),
        excess!("Gauss16", N => spent_by_gauss::<8, 4, N>(), Gauss16::operations(RHS, JACOBIAN, N)),
    ];
    assert!(
        excesses.as_flattened().iter().all(|excess| (0..=80).contains(excess)),
        "{excesses:?}"
    );
}

/// The bound is that of `Radau13` and a switch, unless the right-hand side takes much more than the Jacobian.
#[test]
fn no_step_of_auto_takes_more_than_it_promises() {
    fn check<const N: usize>() {
        let of = |counted: Option<Operations>, most: Operations, what: &str| {
            let counted = row(counted.unwrap_or_else(|| panic!("no such step: {what}")));
            assert!(
                std::iter::zip(counted, row(most)).all(|(counted, most)| counted <= most),
                "{what}: {counted:?} {most:?}"
            );
        };
        let most = Auto::operations(RHS, JACOBIAN, N);
        let busy = Operations::new(1 << 30, 1 << 30, 1 << 30, 1 << 30, 1 << 30, 0);
        for tolerance in [1e-3, 1e-4, 1e-6, 1e-8, 1e-10] {
            let method = Auto::new().rtol(tolerance).atol(tolerance);
            let model = Charged::<N>::new(1e4, 1.0);
            let explicit = spent_where(&method, &Charged::<N>::new(1.0, 1.0), |_, after| after.stiff == 0);
            of(explicit, most, "explicit");
            let model_of_busy = Charged::<N> {
                rhs: busy,
                ..Charged::new(1.0, 1.0)
            };
            let explicit = spent_where(&method, &model_of_busy, |_, after| after.stiff == 0);
            of(
                explicit.map(|spent| spent.and(busy)),
                Auto::operations(busy, JACOBIAN, N),
                "busy",
            );
            let switch = spent_where(&method, &model, |before, after| {
                after.switches > before.switches && after.stiff > before.stiff
            });
            // at 1e-3 it switches after a rejected first step
            if tolerance < 1e-3 {
                of(switch, most, "switch");
            }
            of(
                spent_where(&method, &model, |before, after| after.stiff > before.stiff),
                most,
                "implicit",
            );
        }
    }
    check::<1>();
    check::<5>();
}

/// Their formula is that of `Radau5`, but no step was found that takes all 12 or 17 iterations.
#[test]
fn no_step_of_the_longer_radau_methods_takes_more_than_it_promises() {
    fn check<const N: usize>() {
        let model = Charged::<N>::new(1.0, 0.7);
        let of = |counted: Option<Operations>, most: Operations| {
            let counted = row(counted.expect("a step"));
            assert!(
                std::iter::zip(counted, row(most)).all(|(counted, most)| counted <= most),
                "{counted:?} {most:?}"
            );
        };
        let any = |_, _| true;
        of(
            spent_where(&Radau9::new(), &model, any),
            Radau9::operations(RHS, JACOBIAN, N),
        );
        of(
            spent_where(&Radau13::new(), &model, any),
            Radau13::operations(RHS, JACOBIAN, N),
        );
    }
    check::<1>();
    check::<5>();
}

/// Operations of a step of a Gauss method with all of its iterations.
fn spent_by_gauss<const STAGES: usize, const PAIRS: usize, const N: usize>() -> Option<Operations>
where
    Fixed<Gauss<STAGES, PAIRS>>: Method<Charged<N>, Counted, N>,
{
    // skip the first step, whose prediction is a straight line
    let takes_all =
        |before: Statistics, after: Statistics| before.accepted > 0 && after.iterations == before.iterations + 100;
    // an iteration leaves about 1 / given - 1 of the error: at 0.7, 100 iterations reach rounding errors
    let mut shares = (0..100).map(|share| 0.61 - 4e-4 * f64::from(share));
    shares.find_map(|given| {
        spent_where(
            &Fixed::<Gauss<STAGES, PAIRS>>::new(1.0),
            &Charged::new(200.0, given),
            takes_all,
        )
    })
}
