/* Methods of Boost.odeint. */
#include "problem.h"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>

namespace odeint = boost::numeric::odeint;
namespace ublas = boost::numeric::ublas;

namespace {

long evaluations;

struct Rhs {
    template <class State> void operator()(const State &x, State &slope, double) {
        evaluations++;
        model_rhs(&x[0], &slope[0]);
    }
};

struct Jacobian {
    template <class State, class Matrix> void operator()(const State &x, Matrix &rows, double, State &slope) {
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

template <class State, class Make, class System>
void integrate(State x, Make make, System system, const Task *task, End *end, long count) {
    start_model();
    for (long n = 0; n < count; n++) {
        std::copy_n(task[n].x0, LENGTH, x.begin());
        evaluations = 0;
        end->t = march(make(task->absolute, task->relative), system, x, task[n]);
        std::copy_n(x.begin(), LENGTH, end->x);
        end->evaluations = evaluations;
    }
}

using State = std::array<double, LENGTH>;

} // namespace

extern "C" {

EXPORT void dopri5(const Task *task, End *end, long count) {
    auto make = [](double absolute, double relative) {
        return odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(absolute, relative);
    };
    integrate(State(), make, Rhs(), task, end, count);
}

EXPORT void fehlberg78(const Task *task, End *end, long count) {
    auto make = [](double absolute, double relative) {
        return odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(absolute, relative);
    };
    integrate(State(), make, Rhs(), task, end, count);
}

EXPORT void bulirsch_stoer(const Task *task, End *end, long count) {
    auto make = [](double absolute, double relative) { return odeint::bulirsch_stoer<State>(absolute, relative); };
    integrate(State(), make, Rhs(), task, end, count);
}

EXPORT void rosenbrock4(const Task *task, End *end, long count) {
    auto make = [](double absolute, double relative) {
        return odeint::make_controlled<odeint::rosenbrock4<double>>(absolute, relative);
    };
    integrate(ublas::vector<double>(LENGTH), make, std::make_pair(Rhs(), Jacobian()), task, end, count);
}
}
