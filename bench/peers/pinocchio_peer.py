"""C++ that calls Pinocchio's own algorithms. It needs only the headers, which the PyPI wheel includes."""

from candidate import Candidate, loop
from robot import double_pendulum

HEAD = """// The list of joint types is longer than Boost's prepared headers allow.
#define BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
#define BOOST_MPL_LIMIT_LIST_SIZE 30
#include <pinocchio/fwd.hpp>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/frames.hpp>
"""

ROBOT = """
namespace {name} {{
constexpr int N = {count};
using Vector = Eigen::Matrix<double, N, 1>;
using Square = Eigen::Matrix<double, N, N>;

struct Held {{
  pinocchio::Model model;
  pinocchio::Data data;
  // Joint coordinates from those of the state, and the friction of each joint.
  Square relative = Square::Identity(), absolute = Square::Identity();
  Vector friction = Vector::Zero();
}};

pinocchio::Model chain() {{
  pinocchio::Model model;
  model.gravity.linear() << {gravity};
{bodies}
  return model;
}}

Held make() {{
  Held held;
  held.model = chain();
  held.data = pinocchio::Data(held.model);
{special}
  return held;
}}
{functions}
}}  // namespace {name}
"""

BODY = """  {{
    Eigen::Matrix3d turn, inertia;
    turn << {turn};
    inertia << {inertia};
    const pinocchio::SE3 at(turn, Eigen::Vector3d({at}));
    const auto joint = model.addJoint({parent}, pinocchio::JointModelR{axis}(), at, "j{n}");
    model.appendBodyToJoint(joint, pinocchio::Inertia({mass}, Eigen::Vector3d({com}), inertia), pinocchio::SE3::Identity());
  }}"""

SETUP = "  static Held held = make();\n  Vector q, v, tau = Vector::Zero();\n"
READ = """    q = Eigen::Map<const Vector>(x);
    v = Eigen::Map<const Vector>(x + N);
"""
PENDULUM_READ = """    q = held.relative * Eigen::Map<const Vector>(x);
    v = held.relative * Eigen::Map<const Vector>(x + N);
    tau = -held.friction.cwiseProduct(v);
"""
RHS = """    Eigen::Map<Vector>{{out}} = {absolute}pinocchio::aba(held.model, held.data, q, v, tau);"""
JACOBIAN = """    pinocchio::computeABADerivatives(held.model, held.data, q, v, tau);
    Eigen::Map<Vector>{out} = held.data.ddq;
    Eigen::Map<Square>{out + N} = held.data.ddq_dq;
    Eigen::Map<Square>{out + N + N * N} = held.data.ddq_dv;"""
PENDULUM_JACOBIAN = """    pinocchio::computeABADerivatives(held.model, held.data, q, v, tau);
    Eigen::Map<Vector>{out} = held.absolute * held.data.ddq;
    Eigen::Map<Square>{out + N} = held.absolute * held.data.ddq_dq * held.relative;
    // The friction depends on the rates: its part is -M^-1 times the coefficients.
    const Square inverse = held.data.Minv.selfadjointView<Eigen::Upper>();
    Eigen::Map<Square>{out + N + N * N} =
        held.absolute * (held.data.ddq_dv - inverse * held.friction.asDiagonal()) * held.relative;"""
SPECIAL = """  held.relative << 1, 0, -1, 1;
  held.absolute << 1, 0, 1, 1;
  held.friction << {gamma1}, {gamma2};"""


FRAME = """  const pinocchio::SE3 point(Eigen::Matrix3d::Identity(), Eigen::Vector3d({at}));
  model.addFrame(pinocchio::Frame("point", {joint}, 0, point, pinocchio::OP_FRAME));"""
POINT_SETUP = """  static Held held = make();
  const auto frame = held.model.getFrameId("point");
  Eigen::Matrix<double, 6, N> jacobian = Eigen::Matrix<double, 6, N>::Zero();
  Vector q;
"""
# For a Jacobian at the point in ground axes, `computeFrameJacobian` also updates the frame.
POINT = """    q = Eigen::Map<const Vector>(x);
    pinocchio::computeFrameJacobian(held.model, held.data, q, frame, pinocchio::LOCAL_WORLD_ALIGNED, jacobian);
    Eigen::Map<Eigen::Vector3d>{out} = held.data.oMf[frame].translation();
    Eigen::Map<Eigen::Matrix<double, 3, N>>{out + 3} = jacobian.topRows<3>();"""

FILE = "pinocchio.cpp"


def write(folder, robots, p):
    # A single file, as the headers take a minute to compile.
    parts = [HEAD]
    for robot in robots:
        parts.append(add(folder, robot, "", READ, RHS.format(absolute=""), JACOBIAN))
    chain = double_pendulum(p)
    rhs = RHS.format(absolute="held.absolute * ")
    parts.append(add(folder, chain, SPECIAL.format(**p), PENDULUM_READ, rhs, PENDULUM_JACOBIAN))
    folder.write(FILE, "".join(parts))


def add(folder, robot, special, read, rhs, jacobian):
    functions = []
    for kind, form, code in [("rhs", "aba", rhs), ("jacobian", "computeABADerivatives", jacobian)]:
        symbol = f"{robot.name}_{kind}"
        functions.append(loop(2 * len(robot.bodies), len(robot.bodies), read + code, SETUP, symbol))
        folder.candidates.append(Candidate(robot.name, kind, "Pinocchio", form, FILE, symbol, None))
    bodies = [body(n, link) for n, link in enumerate(robot.bodies)]
    if robot.point:
        bodies.append(FRAME.format(joint=len(robot.bodies), at=joined(robot.point)))
        symbol = f"{robot.name}_point"
        functions.append(loop(2 * len(robot.bodies), 3, POINT, POINT_SETUP, symbol))
        folder.candidates.append(Candidate(robot.name, "point", "Pinocchio", "computeFrameJacobian", FILE, symbol, None))
    return ROBOT.format(
        name=robot.name,
        count=len(robot.bodies),
        gravity=joined(robot.gravity),
        bodies="\n".join(bodies),
        special=special,
        functions="".join(functions),
    )


def body(n, link):
    axis = {(1, 0, 0): "X", (0, 1, 0): "Y", (0, 0, 1): "Z"}[tuple(link.axis)]
    return BODY.format(
        turn=joined(sum(link.turn, [])),
        inertia=joined(sum(link.inertia, [])),
        at=joined(link.at),
        parent=link.parent + 1,
        axis=axis,
        n=n,
        mass=repr(link.mass),
        com=joined(link.com),
    )


def joined(numbers):
    return ", ".join(repr(float(number)) for number in numbers)
