"""The tip of the arm and its Jacobian with SymForce, in Rust: from rotation matrices, and from coordinates by hand."""

import re
import tempfile
from pathlib import Path

import symforce

symforce.set_epsilon_to_number()

import symforce.symbolic as sf
from symforce import codegen
from symforce.codegen.backends.rust import RustConfig

S = sf.Scalar


def about_y(angle):
    cos, sin = sf.cos(angle), sf.sin(angle)
    return sf.Matrix33([[cos, 0, sin], [0, 1, 0], [-sin, 0, cos]])


def about_z(angle):
    cos, sin = sf.cos(angle), sf.sin(angle)
    return sf.Matrix33([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])


def tip(yaw: S, shoulder: S, elbow: S, a: S, b: S, c: S) -> sf.V3:
    lower = sf.V3(a, 0, 0) + about_y(elbow) * sf.V3(b, 0, c)
    return sf.V3(about_z(yaw) * (about_y(shoulder) * lower))


def tip_by_hand(yaw: S, shoulder: S, elbow: S, a: S, b: S, c: S) -> sf.V3:
    both = shoulder + elbow
    out = a * sf.cos(shoulder) + b * sf.cos(both) + c * sf.sin(both)
    up = c * sf.cos(both) - a * sf.sin(shoulder) - b * sf.sin(both)
    return sf.V3(out * sf.cos(yaw), out * sf.sin(yaw), up)


def answers():
    found = []
    for name, function in (("rotation matrices", tip), ("coordinates by hand", tip_by_hand)):
        joints = ["yaw", "shoulder", "elbow"]
        generator = codegen.Codegen.function(function, config=RustConfig()).with_jacobians(which_args=joints)
        with tempfile.TemporaryDirectory() as folder:
            generator.generate_function(output_dir=folder, skip_directory_nesting=True)
            code = next(Path(folder).rglob("*.rs")).read_text()
        operations = int(re.search(r"Total ops: (\d+)", code).group(1))
        functions = code.count(".sin()") + code.count(".cos()")
        text = f"{operations} operations in Rust, {functions} of them sines and cosines"
        found.append((f"SymForce {symforce.__version__}, from {name}", operations, text))
    return found
