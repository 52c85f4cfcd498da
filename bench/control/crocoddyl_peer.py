"""Takes passes of Crocoddyl over the motion of src/control.rs, on request.

The first line of the input has the task as JSON, the first line of the output the versions and the entrants with their
costs. Each further line asks for [entrant, times], and is answered with the nanoseconds of each of so many passes.
"""

import json
import os
import sys
import time

os.environ["OMP_NUM_THREADS"] = "1"

import crocoddyl
import numpy as np
import pinocchio as pin

# two evaluations of the dynamics a step, and one
STEPS = {
    "midpoint": lambda model, step: crocoddyl.IntegratedActionModelRK(model, crocoddyl.RKType.two, step),
    "Euler": crocoddyl.IntegratedActionModelEuler,
}
SOLVERS = {"BoxDDP": crocoddyl.SolverBoxDDP, "BoxFDDP": crocoddyl.SolverBoxFDDP}


class Entrant:
    """A solver, with the motion that it has found followed by its gains from a state that has moved."""

    def __init__(self, robot, task, step, solver):
        self.step, self.method = step, solver
        shooting = shoot(robot, task, STEPS[step])
        self.solver = SOLVERS[solver](shooting)
        self.solver.th_stop = 1e-13
        us = [np.array(task["hold"])] * task["nodes"]
        self.solver.solve(shooting.rollout(us), us, 500, True)
        self.solved, self.iterations = self.solver.cost, self.solver.iter

        shooting.x0 = np.array(task["moved"])
        low, high = -robot.effortLimit, robot.effortLimit
        xs, us = [shooting.x0], []
        for k, (model, data) in enumerate(zip(shooting.runningModels, shooting.runningDatas)):
            u = self.solver.us[k] - self.solver.K[k] @ (xs[k] - self.solver.xs[k])
            us.append(u.clip(low, high))
            model.calc(data, xs[k], us[k])
            xs.append(data.xnext.copy())
        self.before = shooting.calc(xs, us)
        self.solver.setCandidate(xs, us, True)
        # lists of Crocoddyl's own type, which need no conversion
        self.xs, self.us = self.solver.xs.copy(), self.solver.us.copy()
        self.run(1)

    def run(self, times):
        """Nanoseconds of each of so many passes. Each begins anew, with the linearization."""
        nanoseconds = []
        for _ in range(times):
            since = time.perf_counter_ns()
            self.solver.solve(self.xs, self.us, 1, True)
            nanoseconds.append(time.perf_counter_ns() - since)
        return nanoseconds

    def described(self):
        return {
            "name": f"Crocoddyl, {self.step}, {self.method}",
            "solved": self.solved,
            "iterations": self.iterations,
            "before": self.before,
            "after": self.solver.cost,
            "share": self.solver.stepLength,
        }


def read(task):
    """The arm, whose fingers do not move, without friction."""
    robot = pin.buildModelFromUrdf(task["urdf"])
    fingers = [robot.getJointId(name) for name in robot.names if "finger" in name]
    return pin.buildReducedModel(robot, fingers, pin.neutral(robot))


def shoot(robot, task, integrated):
    state = crocoddyl.StateMultibody(robot)
    actuation = crocoddyl.ActuationModelFull(state)

    def dynamics(of_inputs):
        # Crocoddyl's costs are halves of squares
        costs = crocoddyl.CostModelSum(state)
        activation = crocoddyl.ActivationModelWeightedQuad(2.0 * np.array(task["weights"]))
        residual = crocoddyl.ResidualModelState(state, np.array(task["goal"]))
        costs.addCost("state", crocoddyl.CostModelResidual(state, activation, residual), 1.0)
        if of_inputs:
            residual = crocoddyl.ResidualModelControl(state, np.array(task["hold"]))
            costs.addCost("inputs", crocoddyl.CostModelResidual(state, residual), 2.0 * of_inputs)
        return crocoddyl.DifferentialActionModelFreeFwdDynamics(state, actuation, costs)

    nodes = [integrated(dynamics(task["of_inputs"]), task["step"]) for _ in range(task["nodes"])]
    for node in nodes:
        node.u_lb, node.u_ub = -robot.effortLimit, robot.effortLimit
    end = integrated(dynamics(0.0), 0.0)
    shooting = crocoddyl.ShootingProblem(np.array(task["start"]), nodes, end)
    shooting.nthreads = 1
    return shooting


def main():
    answers = sys.stdout
    sys.stdout = sys.stderr
    task = json.loads(sys.stdin.readline())
    robot = read(task)
    entrants = [Entrant(robot, task, step, solver) for step in STEPS for solver in SOLVERS]
    head = {
        "versions": [f"Crocoddyl {crocoddyl.__version__}", f"Pinocchio {pin.__version__}"],
        "entrants": [entrant.described() for entrant in entrants],
    }
    print(json.dumps(head), file=answers, flush=True)
    for line in sys.stdin:
        entrant, times = json.loads(line)
        print(json.dumps(entrants[entrant].run(times)), file=answers, flush=True)


if __name__ == "__main__":
    main()
