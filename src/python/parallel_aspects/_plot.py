# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of maps with matplotlib."""
from typing import Any, Dict, List

import numpy as np

def plot_map(aspect_map: Any, modes: Any, level: float, cells: int, axes: Any) -> Any:
    """See `Map.plot`."""
    chosen = _modes(aspect_map, modes)
    if not chosen:
        raise ValueError("There is no aspect to draw; map at a finer resolution, or in other working modes.")
    axes = _axes(len(chosen), axes)
    for each, mode in zip(axes, chosen):
        _draw(each, str(mode), aspect_map._scene(mode, level, cells))  # pylint: disable=protected-access
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


def _draw(axes: Any, title: str, scene: Dict[str, Any]) -> None:
    from matplotlib.collections import LineCollection, PolyCollection  # pylint: disable=import-outside-toplevel

    for area in scene["areas"]:
        color = area["color"]
        axes.add_collection(PolyCollection(area["polygons"], facecolor=color, edgecolor=color, linewidth=0.3, label=area["title"]))
        axes.annotate(area["label"], _label_place(area["polygons"]), ha="center", va="center", color=area["text_color"])
    for curves in scene["curves"]:
        axes.add_collection(LineCollection(curves["pieces"], color=curves["color"], linewidth=1.2, label=curves["words"]))
    axes.set_title(title)
    if scene["keeps_proportion"]:
        axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_xlabel(scene["axes"][0])
    axes.set_ylabel(scene["axes"][1])


def _area(corners: np.ndarray) -> float:
    x, y = corners[:, 0], corners[:, 1]
    return 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))))


def _label_place(polygons: List[np.ndarray]) -> np.ndarray:
    """In the middle of the largest piece."""
    return max(polygons, key=_area).mean(axis=0)
