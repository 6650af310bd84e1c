# SPDX-License-Identifier: BSD-3-Clause
"""Robots: what the module offers. Each function names the shapes and units of what it takes and gives."""
import csv
import os
import tempfile
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._core import InvalidDescription
from ._asking import Asking, Progress
from ._fields import documented
from ._map import NOT_MAPPED, OUTSIDE, UNDECIDED, Map
from ._results import (
    Aspect,
    BoundaryDistance,
    Check,
    Configuration,
    DirectSolutions,
    Distances,
    Jacobians,
    Path,
    Roadmap,
    Sweep,
    Workspace,
)
from ._text import Mode, Ranges, Values, array, count, named, real, refused, varied_text


def robots() -> List[str]:
    """Names of the shipped robots."""
    return _core.robots()


def load(robot: "Union[str, os.PathLike]", config: "Union[None, str, os.PathLike]" = None) -> "Robot":
    """A shipped robot by its name, or one of your own from its URDF and the YAML that closes its loops.

    Raises InvalidDescription with all `problems`.
    """
    loaded = _core.load(str(robot)) if config is None else _core.load_files(os.fspath(robot), os.fspath(config))
    return Robot(*loaded)


class Robot(Asking):
    """A fully parallel robot; `load` makes one. Immutable.

    Below, k is the number of `coordinates` of a pose, and legs that of the `legs`. Where a question takes `poses`, these
    have shape (k,) for one or (n, k) for several. A working mode is written as the signs of B_jj: "(+,-)" or (1, -1).
    """

    def __init__(self, core: "_core.Robot", notes: Sequence[str] = ()) -> None:
        self._core = core
        self.notes = tuple(notes)  # what the loader took where the description leaves a choice

    def __repr__(self) -> str:
        return f"<Robot {self.name!r}, {self.task_space}, {len(self.legs)} legs>"

    @property
    def name(self) -> str:
        """As its description says."""
        return self._core.name

    @property
    def task_space(self) -> str:
        """How the platform moves: "T1", "T2", "SE2", "T3", "SO3" or "SE3"."""
        return self._core.task_space

    @property
    def coordinates(self) -> Tuple[str, ...]:
        """Of a pose: x, y, z [m], phi [rad], qx, qy, qz, qw, as the task space has them."""
        return tuple(self._core.coordinates)

    @property
    def legs(self) -> Tuple[str, ...]:
        """Their names."""
        return tuple(self._core.legs)

    @property
    def actuated_joints(self) -> Tuple[str, ...]:
        """Their names, one a leg."""
        return tuple(self._core.actuated_joints)

    @property
    def joint_limits(self) -> np.ndarray:
        """Of the actuated joints [rad or m], infinite where there is none: shape (legs, 2)."""
        return self._core.joint_limits

    @property
    def working_modes(self) -> Tuple[str, ...]:
        """All that the kinds of the legs allow, as "(+,-)"."""
        return tuple(self._core.working_modes)

    @property
    def constraints(self) -> Tuple[str, ...]:
        """Kinds of constraints in force besides singularities, as "actuated_limits" or "margins"."""
        return tuple(self._core.constraints)

    @property
    def lengths(self) -> Dict[str, float]:
        """Lengths and coordinates of the legs by name, as "crank_1" or "base_1_x" [m]: what `sweep` can vary."""
        return self._core.lengths

    @property
    def characteristic_length(self) -> float:
        """Makes rotations and displacements comparable [m]."""
        return self._core.characteristic_length

    @property
    def size(self) -> float:
        """Of the robot: distance of base points plus reach [m]."""
        return self._core.size

    @property
    def base_frame(self) -> str:
        """The link that poses are counted from, together with the task frame."""
        return self._core.base_frame

    def describe(self) -> Dict[str, Any]:
        """What is recognised in the description, as of `aspects describe`, of a robot as it was loaded: legs, home pose,
        workspace, limits of all joints. Points and poses are arrays."""
        return self._core.ask("describe", {}, None)

    def constrained(
        self,
        constraint: "Union[None, str, Iterable[str]]" = None,
        no_constraint: "Union[None, str, Iterable[str]]" = None,
        margin: "Optional[Values]" = None,
        tolerance: Optional[float] = None,
    ) -> "Robot":
        """The same robot with these kinds of constraints alone, without those, with margins such as
        {"parallel": 0.05, "serial": 0.1}, and for lengths within this share of their size."""
        keywords = {"constraint": constraint, "no_constraint": no_constraint, "margin": margin, "tolerance": tolerance}
        return Robot(self._core.constrained(keywords), self.notes)

    def with_lengths(self, lengths: "Mapping[str, float]", untied: bool = False) -> "Robot":
        """The same robot with other `lengths` [m]. What a symmetry of the robot takes to each other follows, unless
        untied."""
        values = [(name, real(name, value)) for name, value in named(lengths)]
        return Robot(self._core.with_lengths(values, not untied), self.notes)

    def inverse(self, poses: "np.typing.ArrayLike", mode: Mode) -> np.ndarray:
        """Values of the actuated joints in a working mode [rad or m], shape (legs,) or (n, legs): NaN where a pose is
        out of reach or outside the limits."""
        return _like(poses, self._core.inverse(array("poses", poses), mode))

    def configurations(self, pose: "np.typing.ArrayLike") -> List[Configuration]:
        """All inverse solutions of a pose of shape (k,), within the limits: one a working mode at most."""
        found = self._core.ask("inverse", {"pose": pose}, None)["solutions"]
        return [Configuration(**each) for each in found if each["status"] == "solved"]

    def direct(self, joints: "np.typing.ArrayLike") -> DirectSolutions:
        """All poses that values of the actuated joints can hold, of shape (legs,), whatever the limits."""
        return DirectSolutions(len(self.coordinates), **self._core.ask("direct", {"joints": joints}, None))

    def jacobian(
        self,
        pose: "Optional[np.typing.ArrayLike]" = None,
        joints: "Optional[np.typing.ArrayLike]" = None,
        mode: Optional[Mode] = None,
    ) -> Jacobians:
        """How the platform and the actuated joints move each other, as of `aspects jacobian`: at a pose of shape (k,) in
        each working mode, or at joint values of shape (legs,) in each direct solution. Matrices have shape (legs, legs)."""
        return Jacobians(**self._core.ask("jacobian", {"pose": pose, "joints": joints, "mode": mode}, None))

    def indices(self, poses: "np.typing.ArrayLike", mode: Mode) -> Tuple[np.ndarray, np.ndarray]:
        """The parallel index of each pose, of shape () or (n,), and the serial indices of the legs, (legs,) or (n, legs).
        Each is 0 at a singularity and 1 at most; NaN where a pose is not reached. They are no distances."""
        parallel, serial = self._core.indices(array("poses", poses), mode)
        return _like(poses, parallel), _like(poses, serial)

    def map(self, resolution: Optional[float] = None, *, progress: Progress = None, **options: Any) -> "Union[Map, Roadmap]":
        """The aspects, with proofs, as of `aspects map`; with six degrees of freedom a roadmap, or a map of a `slice`. `progress`
        is called with the share that is done, 0 to 1; what it raises ends the computation, as Ctrl-C does."""
        found = self._core.map({"resolution": resolution, **options}, progress)
        return Roadmap(**found) if isinstance(found, dict) else Map(found)

    def load_map(self, file: "Union[str, os.PathLike]", resolution: Optional[float] = None, **options: Any) -> Map:
        """The map that `Map.save` or `aspects map --save` wrote, if it is of this robot and these options of `map`."""
        return Map(self._core.load_map(os.fspath(file), {"resolution": resolution, **options}))

    def distances(
        self,
        poses: "np.typing.ArrayLike",
        mode: Mode,
        tolerance: Optional[float] = None,
        boxes: Optional[int] = None,
        progress: Progress = None,
    ) -> np.ndarray:
        """The bounds alone [m], of shape (3, 2) or (n, 3, 2): to parallel and serial singularities and to limits of
        actuated joints, each lower (proved) and upper. Without a map, otherwise as `distance`."""
        effort = {"mode": mode, "tolerance": tolerance, "boxes": boxes}
        return _like(poses, self._core.distances(array("poses", poses), effort, progress))

    def check(
        self, times: "np.typing.ArrayLike", poses: "np.typing.ArrayLike", mode: Mode, *, progress: Progress = None, **options: Any
    ) -> Check:
        """Whether the platform can follow these poses in a working mode at every time, proved, as of `aspects check --path`:
        times of shape (n,), rising [s], poses of shape (n, k), straight between them."""
        return Check(**self._core.ask("check", {"path": (_times(times), array("poses", poses)), "mode": mode, **options}, progress))

    def check_joints(
        self,
        times: "np.typing.ArrayLike",
        q: "np.typing.ArrayLike",
        start_pose: "Optional[np.typing.ArrayLike]" = None,
        start_sign: Optional[str] = None,
        *,
        progress: Progress = None,
        **options: Any,
    ) -> Check:
        """Whether the actuated joints can run through these values at every time, proved, as of `aspects check --trajectory`:
        times of shape (n,), q of shape (n, legs), straight between them."""
        keywords = {"trajectory": (_times(times), array("q", q)), "start_pose": start_pose, "start_sign": start_sign, **options}
        return Check(**self._core.ask("check", keywords, progress))

    def choose(
        self,
        times: "np.typing.ArrayLike",
        poses: "np.typing.ArrayLike",
        prefer: Optional[str] = None,
        map: Optional[Map] = None,  # pylint: disable=redefined-builtin
        *,
        progress: Progress = None,
        **options: Any,
    ) -> Dict[str, Any]:
        """In which working modes a path can be done, the best first, as of `aspects choose --path`: times of shape (n,), poses
        of shape (n, k). A map tells aspects; by default one is made with one or two degrees of freedom."""
        core = self._core if map is None else map._core  # pylint: disable=protected-access
        if map is not None and not core.is_of(self._core):
            raise refused("map is of another robot; give one that this robot's map() returned.")
        return core.ask("choose", {"path": (_times(times), array("poses", poses)), "prefer": prefer, **options}, progress)

    def choose_region(self, region: Ranges, slice: "Optional[Values]" = None, progress: Progress = None) -> Dict[str, Any]:  # pylint: disable=redefined-builtin
        """In which working modes all of a box of poses lies in one aspect, as {"x": (-1, 1), "y": (0, 2)}, as of `aspects
        choose --region`."""
        return self._core.ask("choose", {"region": region, "slice": slice}, progress)

    def locate(self, pose: "Optional[np.typing.ArrayLike]" = None, *, progress: Progress = None, **options: Any) -> Dict[str, Any]:
        """Which configurations a pose or values of the actuated joints can be, and which aspects hold them, as of `aspects
        locate`: in a map that is computed first. `Map.locate` asks a map that is there, of many poses."""
        return self._core.ask("locate", {"pose": pose, **options}, progress)

    def sweep(
        self,
        vary: "Union[str, Mapping[str, Union[float, Sequence[float]]]]",
        report: "Union[str, Iterable[str]]" = ("count",),
        file: "Union[None, str, os.PathLike]" = None,
        sample: str = "grid",
        designs: Optional[int] = None,
        resolution: Optional[float] = None,
        slice: "Optional[Values]" = None,  # pylint: disable=redefined-builtin
        modes: "Union[None, str, Iterable[Mode]]" = None,
        untied: bool = False,
        shard: Optional[str] = None,
        threads: int = 0,
        progress: Progress = None,
        **shape: Any,
    ) -> Sweep:
        """Maps many designs.

        vary: `lengths` with a value, or with the ends of a range and how many values it has, as
            {"crank_1": (6, 8, 3), "rod_2": 7} [m]; with sample="sobol" the ends alone, and `designs` says how many.
        report: some of "count", "measures", "clearance" and "workspace", this with `shape` as `Map.workspace` has it.
        file: rows are written there as they are done, and the same call goes on where it was stopped.
        """
        texts = {"vary": varied_text(vary), "report": report, "sample": sample, "shard": shard}
        keywords = {"designs": designs, "resolution": resolution, "slice": slice, "mode": modes, "untied": untied}
        with tempfile.TemporaryDirectory() as folder:
            rows = os.fspath(file) if file is not None else os.path.join(folder, "sweep.csv")
            self._core.sweep(rows, {**texts, **keywords, **shape}, count("threads", threads), progress)
            return read_sweep(rows)

    def uniqueness(
        self, slice: "Optional[Values]" = None, *, progress: Progress = None, **options: Any  # pylint: disable=redefined-builtin
    ) -> Dict[str, Any]:
        """Which poses of an aspect have the same actuated values, and where direct solutions meet, as of `aspects uniqueness`.
        Poses of the answer are arrays."""
        return self._core.ask("uniqueness", {"slice": slice or None, **options}, progress)

    def cusp_curves(self, over: "Union[str, Ranges]", progress: Progress = None) -> Dict[str, Any]:
        """The curves that cusps form while an actuated joint is held at each value of a range in turn [m or rad], as
        {"strut_1_joint": (10, 32)}, or by its name within its limits, as of `aspects uniqueness --cusps-over`. Of the
        `points` of a curve, in turn, there are arrays besides: `poses` (n, k) and `q` (n, legs)."""
        answer = self.uniqueness(cusps_over=over, progress=progress)
        for curve in answer["cusp_curves"]:
            curve["poses"] = np.array([point["pose"] for point in curve["points"]])
            curve["q"] = np.array([point["actuated"] for point in curve["points"]])
        return answer


if not hasattr(_core.Robot, "sweep"):  # which may be left out of a build
    del Robot.sweep

for _method in ("map", "locate", "check", "choose", "jacobian", "uniqueness"):
    documented(getattr(Robot, _method), _method)
documented(Robot.check_joints, "check")


def read_sweep(file: "Union[str, os.PathLike]") -> Sweep:
    """The rows of a file that `Robot.sweep`, `aspects sweep` or `aspects merge` wrote."""
    with open(file, encoding="ascii", newline="") as stream:
        if not stream.readline().startswith("# aspects sweep "):
            raise refused(f"'{os.fspath(file)}' is not the file of a sweep; give one that a sweep wrote.")
        names, *rows = csv.reader(stream)
    columns: Dict[str, np.ndarray] = {}
    for name, cells in zip(names, zip(*rows) if rows else [()] * len(names)):
        texts = name == "status"
        columns[name] = np.array([cell if texts else float(cell or "nan") for cell in cells], dtype=str if texts else float)
    return Sweep(columns)


def _times(times: "np.typing.ArrayLike") -> List[float]:
    return np.atleast_1d(array("times", times)).tolist()


def _like(poses: "np.typing.ArrayLike", rows: np.ndarray) -> np.ndarray:
    """The one row where `poses` is one pose."""
    return rows[0] if np.ndim(poses) == 1 else rows
