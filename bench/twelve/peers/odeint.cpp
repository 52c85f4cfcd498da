/* Methods of Boost.odeint. */
#include "problem.h"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <exception>

namespace odeint = boost::numeric::odeint;
namespace ublas = boost::numeric::ublas;

namespace {

long evaluations, jacobians;

struct Rhs {
    template <class State> void operator()(const State &x, State &slope, double) {
        evaluations++;
        model_rhs(&x[0], &slope[0]);
    }
};

struct Jacobian {
    template <class State, class Matrix> void operator()(const State &x, Matrix &rows, double, State &slope) {
        jacobians++;
        model_jacobian_rows(&x[0], &rows.data()[0]);
        std::fill(slope.begin(), slope.end(), 0.0);
    }
};

/* Like `integrate_adaptive`, but with a maximum number of evaluations. */
template <class Stepper, class System, class State>
double march(Stepper stepper, System system, State &x, const Task &task) {
    double t = 0.0, h = task.h0;
    while (t < task.t1) {
        if (evaluations > PATIENCE || !(t + 1e-3 * h > t)) return -1.0;
        bool last = t + h >= task.t1;
        if (last) h = task.t1 - t;
        if (stepper.try_step(system, x, t, h) == odeint::success && last) t = task.t1;
    }
    return t;
}

/* States at the output times. */
template <class Stepper, class System, class State>
void sample(Stepper stepper, System system, State x, const Task &task, End &end) {
    evaluations = 0;
    stepper.initialize(x, 0.0, task.h0);
    for (long n = 0; n < task.outputs; n++) {
        double t = output_time(&task, n);
        while (stepper.current_time() < t) {
            if (evaluations > PATIENCE) return;
            stepper.do_step(system);
        }
        stepper.calc_state(t, x);
        std::copy_n(x.begin(), LENGTH, end.along[n]);
        end.outputs = n + 1;
    }
}

/* Stepper without dense output, or none that takes the same steps. */
struct None {};
template <class System, class State> void sample(None, System, State, const Task &, End &) {}

template <class State, class Make, class MakeDense, class System>
void integrate(State x, Make make, MakeDense make_dense, System system, const Task *task, End *end, long count) {
    start_model();
    for (long n = 0; n < count; n++) {
        std::copy_n(task[n].x0, LENGTH, x.begin());
        end->outputs = 0;
        if (task->outputs > 0) {
            try {
                sample(make_dense(task->absolute, task->relative), system, x, *task, *end);
            } catch (const std::exception &) { // too many failed steps
            }
        }
        evaluations = jacobians = 0;
        end->t = march(make(task->absolute, task->relative), system, x, task[n]);
        std::copy_n(x.begin(), LENGTH, end->x);
        end->evaluations = evaluations;
        end->jacobians = jacobians;
    }
}

using State = std::array<double, LENGTH>;

} // namespace

/* Function of a method whose steppers, plain and with dense output, are made from two tolerances. */
#define METHOD(name, state, system, stepper, dense) \
    extern "C" EXPORT void name(const Task *task, End *end, long count) { \
        auto make = [](double absolute, double relative) { return stepper; }; \
        auto make_dense = [](double absolute, double relative) { return dense; }; \
        integrate(state, make, make_dense, system, task, end, count); \
    }

using Dopri5 = odeint::runge_kutta_dopri5<State>;
using Fehlberg78 = odeint::runge_kutta_fehlberg78<State>;
using Rosenbrock4 = odeint::rosenbrock4<double>;

METHOD(dopri5, State(), Rhs(), odeint::make_controlled<Dopri5>(absolute, relative),
       odeint::make_dense_output<Dopri5>(absolute, relative))
METHOD(fehlberg78, State(), Rhs(), odeint::make_controlled<Fehlberg78>(absolute, relative), None())
METHOD(bulirsch_stoer, State(), Rhs(), odeint::bulirsch_stoer<State>(absolute, relative), None())
METHOD(rosenbrock4, ublas::vector<double>(LENGTH), std::make_pair(Rhs(), Jacobian()),
       odeint::make_controlled<Rosenbrock4>(absolute, relative),
       odeint::make_dense_output<Rosenbrock4>(absolute, relative))
