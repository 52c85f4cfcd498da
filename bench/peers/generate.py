"""Writes the code of all peers that are installed: `generate.py DATA PENDULUM FOLDER`, with the data of the testbed.

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
    data, pendulum_file, path = (Path(argument) for argument in sys.argv[1:])
    robots, pendulum = robot.read(data / "robots.json"), json.loads(pendulum_file.read_text())
    more = [
        robot.from_urdf("xarm7", data / "urdf/xarm7.urdf"),
        robot.from_urdf("solo", data / "urdf/solo12.urdf", flies=True),
    ]
    folder = Folder(path)
    found = {}
    for module, package, what in PEERS:
        found[module] = importlib.util.find_spec(module) is not None
        if not found[module]:
            folder.note(f"{what}: not installed; `pip install {package}`")
    if found["casadi"]:
        import casadi_peer

        casadi_peer.write(folder, [*robots, *more], pendulum)
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
