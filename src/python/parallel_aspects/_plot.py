# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of maps with matplotlib."""
from typing import Any, Dict, List

import numpy as np

LINES = {
    "parallel": {"color": "#b2182b", "linewidth": 1.2},
    "serial": {"color": "black", "linewidth": 1.0},
}
OTHER_LINE = {"color": "0.4", "linewidth": 0.8, "linestyle": ":"}


def plot_map(aspect_map: Any, modes: Any, level: float, cells: int, axes: Any) -> Any:
    """See `Map.plot`."""
    chosen = _modes(aspect_map, modes)
    if not chosen:
        raise ValueError("There is no aspect to draw; map at a finer resolution, or in other working modes.")
    axes = _axes(len(chosen), axes)
    for each, mode in zip(axes, chosen):
        _draw(each, aspect_map, mode, aspect_map.outlines(mode, level, cells))
    return axes[0].figure


def _modes(aspect_map: Any, modes: Any) -> List[Any]:
    if modes is None:
        return list(aspect_map.working_modes)
    is_one = isinstance(modes, str) or all(isinstance(sign, (int, np.integer)) for sign in modes)
    return [modes] if is_one else list(modes)


def _axes(count: int, axes: Any) -> List[Any]:
    import matplotlib.pyplot as plt  # pylint: disable=import-outside-toplevel

    if axes is None:
        columns = min(count, 4)
        rows = -(-count // columns)
        figure, made = plt.subplots(rows, columns, figsize=(4 * columns, 4 * rows), squeeze=False, tight_layout=True)
        for unused in made.flat[count:]:
            unused.set_visible(False)
        return list(made.flat[:count])
    given = list(np.atleast_1d(axes).flat)
    if len(given) < count:
        raise ValueError(f"axes has {len(given)} entries for {count} working modes; give as many.")
    return given


def _draw(axes: Any, aspect_map: Any, mode: Any, outlines: Dict[str, list]) -> None:
    from matplotlib.collections import LineCollection, PolyCollection  # pylint: disable=import-outside-toplevel
    import matplotlib.pyplot as plt  # pylint: disable=import-outside-toplevel

    palette = plt.get_cmap("tab20")
    for number in sorted({number for number, _ in outlines["polygons"] if number > 0}):
        polygons = [corners for which, corners in outlines["polygons"] if which == number]
        color = palette((number - 1) % 20)
        axes.add_collection(PolyCollection(polygons, facecolor=color, edgecolor=color, linewidth=0.3, label=str(number)))
        axes.annotate(str(number), _label_place(polygons), ha="center", va="center")
    for kind in sorted({kind for kind, _ in outlines["lines"]}):
        lines = [ends for which, ends in outlines["lines"] if which == kind]
        axes.add_collection(LineCollection(lines, label=kind, **LINES.get(kind, OTHER_LINE)))
    axes.set_title(str(mode))
    axes.set_aspect("equal")
    axes.autoscale_view()
    names = aspect_map.coordinates[:2] or ("tilt x", "tilt y")
    axes.set_xlabel(f"{names[0]} [{'m' if names[0] in 'xyz' else 'rad'}]")
    axes.set_ylabel(f"{names[-1]} [{'m' if names[-1] in 'xyz' else 'rad'}]")


def _area(corners: np.ndarray) -> float:
    x, y = corners[:, 0], corners[:, 1]
    return 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))))


def _label_place(polygons: List[np.ndarray]) -> np.ndarray:
    """In the middle of the largest piece."""
    return max(polygons, key=_area).mean(axis=0)
