# SPDX-License-Identifier: BSD-3-Clause
"""Maps: the aspects of a robot."""
import os
from types import SimpleNamespace
from typing import Any, Dict, Sequence, Tuple, Union

import numpy as np

from ._asking import Asking
from ._fields import answer
from ._results import Aspect
from ._text import Mode, array, count, real

UNDECIDED = 0  # closer to a singularity or a limit than the map can decide
OUTSIDE = -1  # proved to lie in no aspect of the working mode
NOT_MAPPED = -2  # outside the region of the map


class Map(Asking, SimpleNamespace):
    """The aspects of a robot, certified; `Robot.map` makes one. Below, k is the number of coordinates of a pose, and d that
    of `coordinates`, over which the map is made. The aspect with the id i is `aspects[i - 1]`; `unresolved` has shape (n, 2).
    """

    def __init__(self, core: Any) -> None:
        super().__init__(**core.fields)
        self._core = core
        self.aspects: Tuple[Aspect, ...] = tuple(Aspect(**each) for each in core.fields["aspects"])
        self.unresolved = np.array(core.fields["unresolved"], dtype=int).reshape(-1, 2)

    def __repr__(self) -> str:
        return f"<Map of {len(self.aspects)} aspects, {self.proved_count} of them proved to differ>"

    @property
    def coordinates(self) -> Tuple[str, ...]:
        """Of its boxes [m or rad]; none in SO3."""
        return tuple(self._core.coordinates)

    def locate(self, poses: "np.typing.ArrayLike", mode: Mode) -> "Union[int, np.ndarray]":
        """Which aspect holds poses of shape (k,) or (n, k) in a working mode: an id or an array of shape (n,). UNDECIDED,
        OUTSIDE and NOT_MAPPED, which are not positive, stand where no aspect is proved to."""
        found = self._core.locate(array("poses", poses), mode)
        return int(found[0]) if np.ndim(poses) == 1 else found

    def boxes(self, aspect: int) -> np.ndarray:
        """The boxes that are proved to lie in an aspect, shape (n, d, 2): lower and upper end of each coordinate."""
        return self._core.boxes(count("aspect", aspect))

    def undecided(self, mode: Mode) -> np.ndarray:
        """The boxes of a working mode that are neither in an aspect nor proved to meet none, shape (n, d, 2)."""
        return self._core.undecided(mode)

    def save(self, file: "Union[str, os.PathLike]") -> None:
        """Writes it for `Robot.load_map` and `aspects map --load`."""
        self._core.save(os.fspath(file))

    def outlines(self, mode: Mode, level: float = 0.0, cells: int = 200) -> Dict[str, list]:
        """What `plot` draws of a working mode, in the plane of phi [rad], z [m] or torsion [rad] at this level: "polygons",
        pairs of an id and corners of shape (m, 2), and "lines", pairs of what ends there and two ends of shape (2, 2).
        Traced on a grid of `cells` squared; for pictures, not certified."""
        scene = self._scene(mode, level, cells)
        return {
            "polygons": [(area["aspect"], corners) for area in scene["areas"] for corners in area["polygons"]],
            "lines": [(curves["kind"], ends) for curves in scene["curves"] for ends in curves["pieces"]],
        }

    def _scene(self, mode: Mode, level: float, cells: int) -> Dict[str, Any]:
        return self._core.scene(mode, real("level", level), count("cells", cells))

    def plot(
        self,
        modes: "Union[None, Mode, Sequence[Mode]]" = None,
        level: float = 0.0,
        cells: int = 200,
        axes: Any = None,
    ) -> Any:
        """Draws the aspects with matplotlib, a picture for each working mode: filled, with their ids, and with what bounds
        them, in the colours of all pictures of this map. modes: by default all that have aspects; axes: as many matplotlib axes as there are modes. Returns the
        figure."""
        from ._plot import plot_map  # pylint: disable=import-outside-toplevel

        return plot_map(self, modes, level, cells, axes)


answer(Map)
