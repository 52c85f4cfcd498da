/* Methods of Boost.odeint. */
#include "double_pendulum.h"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>

namespace odeint = boost::numeric::odeint;
namespace ublas = boost::numeric::ublas;

namespace {

struct Pendulum {
    void *model;
    long evaluations = 0;

    explicit Pendulum(double gamma) : model(double_pendulum(gamma)) {}
    Pendulum(const Pendulum &) = delete;
    ~Pendulum() { double_pendulum_free(model); }

    template <class State> void operator()(const State &x, State &slope, double) {
        evaluations++;
        double_pendulum_rhs(model, &x[0], &slope[0]);
    }
};

struct Jacobian {
    Pendulum &pendulum;

    template <class State, class Matrix> void operator()(const State &x, Matrix &rows, double, State &slope) {
        double columns[16];
        double_pendulum_jacobian(pendulum.model, &x[0], columns);
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) rows(i, j) = columns[4 * j + i];
            slope[i] = 0.0;
        }
    }
};

/* Like `integrate_adaptive`, but with a maximum number of evaluations. */
template <class Stepper, class System, class State>
double march(Stepper stepper, System system, const Pendulum &pendulum, State &x, const Task &task) {
    double t = 0.0, h = task.h0;
    while (t < task.t1) {
        if (pendulum.evaluations > PATIENCE || !(t + 1e-3 * h > t)) return -1.0;
        bool last = t + h >= task.t1;
        if (last) h = task.t1 - t;
        if (stepper.try_step(system, x, t, h) == odeint::success && last) t = task.t1;
    }
    return t;
}

using State = std::array<double, 4>;

template <class Make> void explicitly(Make make, const Task *task, End *end, long count) {
    Pendulum pendulum(task->gamma);
    for (long n = 0; n < count; n++) {
        State x;
        std::copy_n(task[n].x0, 4, x.begin());
        pendulum.evaluations = 0;
        end->t = march(make(task->tolerance), std::ref(pendulum), pendulum, x, task[n]);
        std::copy_n(x.begin(), 4, end->x);
        end->evaluations = pendulum.evaluations;
    }
}

} // namespace

extern "C" {

EXPORT void dopri5(const Task *task, End *end, long count) {
    auto make = [](double tolerance) {
        return odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(tolerance, tolerance);
    };
    explicitly(make, task, end, count);
}

EXPORT void fehlberg78(const Task *task, End *end, long count) {
    auto make = [](double tolerance) {
        return odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance);
    };
    explicitly(make, task, end, count);
}

EXPORT void bulirsch_stoer(const Task *task, End *end, long count) {
    auto make = [](double tolerance) { return odeint::bulirsch_stoer<State>(tolerance, tolerance); };
    explicitly(make, task, end, count);
}

EXPORT void rosenbrock4(const Task *task, End *end, long count) {
    Pendulum pendulum(task->gamma);
    for (long n = 0; n < count; n++) {
        ublas::vector<double> x(4);
        std::copy_n(task[n].x0, 4, x.begin());
        pendulum.evaluations = 0;
        auto stepper = odeint::make_controlled<odeint::rosenbrock4<double>>(task->tolerance, task->tolerance);
        auto system = std::make_pair(std::ref(pendulum), Jacobian{pendulum});
        end->t = march(stepper, system, pendulum, x, task[n]);
        std::copy_n(x.begin(), 4, end->x);
        end->evaluations = pendulum.evaluations;
    }
}
}
