"""Links on a cart with PyDy: derivation by Kane's method, and the accelerations solved with symbols."""

import time
from importlib.metadata import version

import sympy as sm
from pydy.models import n_link_pendulum_on_cart

#: Each further link takes several times as long.
LINKS = (4, 5, 6, 7)


def answers():
    found = []
    for links in LINKS:
        since = time.perf_counter()
        system = n_link_pendulum_on_cart(links, cart_force=True, joint_torques=False)
        derived = time.perf_counter() - since
        since = time.perf_counter()
        solved = system.eom_method.rhs()
        shared, reduced = sm.cse(solved)
        seconds = time.perf_counter() - since
        operations = sum(sm.count_ops(e) for _, e in shared) + sum(sm.count_ops(e) for e in reduced)
        text = f"derived in {derived:.2f} s and solved, with common subexpressions, in {seconds:.1f} s; {operations} operations"
        found.append((f"PyDy {version('pydy')} with SymPy {sm.__version__}, {links} links", seconds, text))
    return found
