"""Animations as HTML."""

from __future__ import annotations

import html
import json
import uuid
from importlib import resources
from typing import Any

import numpy as np
from numpy.typing import NDArray


def page(
    name: str,
    times: NDArray[np.float64],
    frames: list[list[tuple[str, str, str, NDArray[np.float64], float]]],
    speed: float,
) -> str:
    """A canvas with a script that draws the frames, and nothing from elsewhere.

    Mechanisms whose points share one depth are seen along z; others from in front, to the right and above.
    """
    points = np.concatenate([np.empty((0, 3)), *(shape[3] for frame in frames for shape in frame)])
    flat = len(points) == 0 or np.ptp(points[:, 2]) <= 1e-9 * max(1e-9, float(np.ptp(points[:, :2])))
    view = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]) if flat else _from_the_side()
    shapes = [{"kind": kind, "body": body} for _, body, kind, _, _ in frames[0]] if frames else []
    drawn = [[_projected(shape, view) for shape in frame] for frame in frames]
    scene: dict[str, Any] = {
        "shapes": shapes,
        "frames": drawn,
        "times": [round(float(t), 6) for t in times],
        "speed": speed,
    }
    painter, animation = (_script(name) for name in ("canvas.js", "animation.js"))
    place = f"pendulum-{uuid.uuid4().hex}"
    data = json.dumps(scene, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    return (
        f'<figure><canvas id="{place}" width="480" height="480" role="img" aria-label="{html.escape(name)} in motion">'
        f"</canvas></figure><script>(() => {{\n{painter}\n{animation.rstrip()}"
        f"(document.getElementById({json.dumps(place)}), {data});\n}})();</script>"
    )


def _script(name: str) -> str:
    script = resources.files(__package__).joinpath(name).read_text(encoding="utf-8")
    return script.replace("export default ", "")


def _from_the_side() -> NDArray[np.float64]:
    """Projection onto a plane seen from (3, -4, 2), with z upward."""
    towards = np.array([3.0, -4.0, 2.0])
    right = np.cross([0.0, 0.0, 1.0], towards)
    up = np.cross(towards, right)
    return np.array([right / np.linalg.norm(right), up / np.linalg.norm(up)])


def _projected(shape: tuple[str, str, str, NDArray[np.float64], float], view: NDArray[np.float64]) -> list[Any]:
    _, _, _, points, radius = shape
    flat = np.round(points @ view.T, 5).ravel().tolist()
    return [flat, round(float(radius), 5)]
