# SPDX-License-Identifier: BSD-3-Clause
"""Questions that a robot and a map of it answer alike."""
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from ._fields import documented
from ._results import Distances, Path, Workspace, distances_of
from ._text import Mode

Progress = Optional[Callable[[float], Any]]


class Asking:
    """A map is asked itself; a robot computes one first where that is needed, or with six degrees of freedom a roadmap."""

    _core: Any

    def plan(
        self,
        start: "Optional[np.typing.ArrayLike]" = None,
        goal: "Optional[np.typing.ArrayLike]" = None,
        start_mode: Optional[Mode] = None,
        goal_mode: Optional[Mode] = None,
        *,
        progress: Progress = None,
        **options: Any,
    ) -> Path:
        """A path that is proved, or a proof that there is none, as of `aspects plan`."""
        ends = {"start": start, "goal": goal, "start_mode": start_mode, "goal_mode": goal_mode}
        return Path(**self._core.ask("plan", {**ends, **options}, progress))

    def graph(self, *, progress: Progress = None, **options: Any) -> Dict[str, Any]:
        """Which aspects are joined through gates, and which are proved apart, as of `aspects graph`. Poses of the answer are
        arrays."""
        return self._core.ask("graph", options, progress)

    def connect(
        self, start: "np.typing.ArrayLike", goal: "np.typing.ArrayLike", *, progress: Progress = None, **options: Any
    ) -> Dict[str, Any]:
        """Whether two poses lie in one aspect, by working mode, as of `aspects connect`. Poses of the answer are arrays."""
        return self._core.ask("connect", {"start": start, "goal": goal, **options}, progress)

    def distance(
        self, pose: "np.typing.ArrayLike", mode: Optional[Mode] = None, *, progress: Progress = None, **options: Any
    ) -> "Union[Distances, Tuple[Distances, ...]]":
        """How far singularities and limits are from a pose, between a bound that is proved and a witness, as of `aspects
        distance`: in a working mode, or without one in each. Bounds of a map are tighter."""
        return distances_of(self._core.ask("distance", {"pose": pose, "mode": mode, **options}, progress), mode)

    def workspace(
        self, shape: str, aspect: "Union[None, int, Sequence[int]]" = None, *, progress: Progress = None, **options: Any
    ) -> List[Workspace]:
        """The largest regular shape in each aspect, by default in all, as of `aspects workspace`. Ranges and values are texts or
        mappings, as {"phi": (-0.2, 0.2)} and {"x": 4.5}."""
        answer = self._core.ask("workspace", {"shape": shape, "aspect": aspect, **options}, progress)
        return [Workspace(**each) for each in answer["workspaces"]]


for _question in ("plan", "graph", "connect", "distance", "workspace"):
    documented(getattr(Asking, _question), _question)
