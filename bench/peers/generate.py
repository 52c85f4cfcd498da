"""Writes the code of all peers that are installed: `generate.py ROBOTS PENDULUM FLYING FOLDER`.

The folder then holds C and C++ files and their list, `candidates.json`, with a note for each peer that is missing.
"""

import importlib.util
import json
import sys
from pathlib import Path

import robot
from candidate import Folder

# Module, package on PyPI, purpose.
PEERS = [
    ("casadi", "casadi", "CasADi's C code"),
    ("sympy", "sympy", "SymPy's C code"),
    ("pinocchio", "pin", "Pinocchio"),
]


def main():
    robots_file, pendulum_file, flying_file, path = (Path(argument) for argument in sys.argv[1:])
    robots, pendulum = robot.read(robots_file), json.loads(pendulum_file.read_text())
    flying = robot.flying(flying_file)
    folder = Folder(path)
    found = {}
    for module, package, what in PEERS:
        found[module] = importlib.util.find_spec(module) is not None
        if not found[module]:
            folder.note(f"{what}: not installed; `pip install {package}`")
    if found["casadi"]:
        import casadi_peer

        casadi_peer.write(folder, [*robots, flying], pendulum)
        folder.version("casadi")
    if found["sympy"]:
        import sympy_peer

        sympy_peer.write(folder, robots, pendulum)
        folder.version("sympy")
    if found["pinocchio"]:
        include = headers()
        if (include / "eigen3").is_dir():
            import pinocchio_peer

            pinocchio_peer.write(folder, robots, pendulum)
            folder.version("pin")
            folder.include = [str(include), str(include / "eigen3")]
        else:
            folder.note("Pinocchio: its headers want those of Eigen; `pip install cmeel-eigen`")
    folder.close()


def headers():
    """Header folder of wheels built with cmeel."""
    spec = importlib.util.find_spec("pinocchio")
    return next(parent for parent in Path(spec.origin).parents if parent.name == "cmeel.prefix") / "include"


main()
