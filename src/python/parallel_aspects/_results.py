# SPDX-License-Identifier: BSD-3-Clause
"""What questions are answered with. Lengths in m, angles in rad, times in s; a pose is an array of shape (k,), in the
order of `Robot.coordinates`; a joint vector has shape (legs,), in the order of `Robot.legs`."""
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, Dict, List, Sequence, Tuple, Union

import numpy as np

from ._fields import answer


@answer
class Configuration(SimpleNamespace):
    """A pose in one working mode."""


@answer
class DirectSolutions(SimpleNamespace):
    """The poses that given joint values can hold, by falling det A.

    Of `assembly_modes` there are arrays besides: `poses` (n, k), `determinants` (n,) and `near_singular` (n,), of bool.
    """

    def __init__(self, coordinates: int, assembly_modes: Sequence[Dict[str, Any]], **fields: Any) -> None:
        columns = {name: np.array([each[name] for each in assembly_modes]) for name in ("pose", "det_a", "near_singular")}
        super().__init__(
            poses=columns["pose"].reshape(-1, coordinates),
            determinants=columns["det_a"],
            near_singular=columns["near_singular"].astype(bool),
            assembly_modes=tuple(SimpleNamespace(**each) for each in assembly_modes),
            **fields,
        )


@answer
class Aspect(SimpleNamespace):
    """A connected set free of singularities, proved; it is part of one generalized aspect."""


@answer
class Roadmap(SimpleNamespace):
    """What there is in place of a map with six degrees of freedom; each of `sides` has its fields, too."""

    def __init__(self, sides: Sequence[Dict[str, Any]], **fields: Any) -> None:
        super().__init__(sides=tuple(SimpleNamespace(**each) for each in sides), **fields)


@answer
class BoundaryDistance(SimpleNamespace):
    """How far singularities or limits of one kind are, as the root mean square of how far the anchors move [m]."""


@answer
class Distances(SimpleNamespace):
    """The distances of one configuration; each a `BoundaryDistance`."""

    def __init__(self, **fields: Any) -> None:
        kinds = {name: BoundaryDistance(**fields[name]) for name in ("parallel", "serial", "actuated_limit")}
        super().__init__(**{**fields, **kinds})


def distances_of(found: Dict[str, Any], mode: Any) -> "Union[Distances, Tuple[Distances, ...]]":
    """In that mode, or in every one."""
    distances = tuple(Distances(**each) for each in found["answers"])
    return distances if mode is None else distances[0]


@answer
class Jacobian(SimpleNamespace):
    """The matrices of one configuration."""


@answer
class Jacobians(SimpleNamespace):
    """How the platform and the actuated joints move each other; each of `configurations` is a `Jacobian`."""

    def __init__(self, configurations: Sequence[Dict[str, Any]], **fields: Any) -> None:
        super().__init__(configurations=tuple(Jacobian(**each) for each in configurations), **fields)


@answer
class Check(SimpleNamespace):
    """What is proved of a trajectory.

    samples: `times` (n,), `poses` (n, k), `q` (n, legs), `parallel_index` (n,) and `serial_indices` (n, legs).
    """


@answer
class Path(SimpleNamespace):
    """A path, each segment of which is proved free of singularities, or why there is none.

    In place of `path`: `poses` (n, k), `q` (n, legs) and `modes` (n) of its points. True where there is one.
    """

    def __init__(self, crossings: Sequence[Dict[str, Any]], **fields: Any) -> None:
        super().__init__(crossings=tuple(SimpleNamespace(**each) for each in crossings), **fields)

    def __bool__(self) -> bool:
        return self.answer == "yes"


@answer
class Workspace(SimpleNamespace):
    """The largest regular shape in an aspect."""


@dataclass(frozen=True, eq=False)
class Sweep:
    """The rows of a sweep: a column is an array of shape (designs,); a figure that is not known is NaN."""

    columns: Dict[str, np.ndarray]

    def __getitem__(self, name: str) -> np.ndarray:
        return self.columns[name]

    def __len__(self) -> int:
        return len(self.columns["design"])

    def names(self) -> List[str]:
        """Of the columns, in their order."""
        return list(self.columns)
