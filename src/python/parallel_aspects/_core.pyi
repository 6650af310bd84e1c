# SPDX-License-Identifier: BSD-3-Clause
# The compiled part: private; Robot and Map stand on it, and document it.
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

class InvalidDescription(ValueError):
    problems: List[str]

def robots() -> List[str]: ...
def load(name: str) -> Tuple[Robot, List[str]]: ...
def load_files(urdf: str, config: str) -> Tuple[Robot, List[str]]: ...

Progress = Optional[Callable[[float], Any]]
Pairs = Sequence[Tuple[str, float]]

class Robot:
    name: str
    task_space: str
    coordinates: List[str]
    legs: List[str]
    actuated_joints: List[str]
    joint_limits: np.ndarray
    working_modes: List[str]
    constraints: List[str]
    lengths: Dict[str, float]
    characteristic_length: float
    size: float
    base_frame: str
    def constrained(self, only: str, without: str, margins: str, tolerance: str) -> Robot: ...
    def with_lengths(self, values: Pairs, keep_ties: bool) -> Robot: ...
    def inverse(self, poses: Any, mode: str) -> np.ndarray: ...
    def inverse_in_modes(self, pose: Any) -> Tuple[List[str], np.ndarray]: ...
    def direct(self, q: Any) -> Dict[str, Any]: ...
    def indices(self, poses: Any, mode: str) -> Tuple[np.ndarray, np.ndarray]: ...
    def map(
        self,
        resolution: Optional[float],
        region: str,
        slice: str,
        modes: str,
        threads: int,
        extra_levels: int,
        complete: bool,
        progress: Progress,
    ) -> Map: ...
    def load_map(self, file: str, resolution: Optional[float], region: str, slice: str, modes: str) -> Map: ...
    def distance(self, pose: Any, mode: str, tolerance: float, boxes: int) -> Dict[str, Any]: ...
    def distances(self, poses: Any, mode: str, tolerance: float, boxes: int, progress: Progress) -> np.ndarray: ...
    def check(self, times: List[float], poses: Any, mode: str) -> Dict[str, Any]: ...
    def check_joints(
        self, times: List[float], q: Any, start_pose: Any, start_sign: int, pass_serial: bool
    ) -> Dict[str, Any]: ...
    def choose(self, times: List[float], poses: Any, prefer: str, map: Optional[Map]) -> Dict[str, Any]: ...
    def choose_region(self, region: str, slice: str) -> Dict[str, Any]: ...
    def plan(
        self,
        start: Any,
        goal: Any,
        start_mode: str,
        goal_mode: str,
        policy: str,
        prefer: str,
        samples: int,
        seed: int,
        progress: Progress,
    ) -> Dict[str, Any]: ...
    def sweep(self, file: str, texts: Mapping[str, str], untied: bool, threads: int, progress: Progress) -> None: ...
    def uniqueness(self, slice: str, resolution: Optional[float], progress: Progress) -> Dict[str, Any]: ...

class Map:
    aspects: List[Dict[str, Any]]
    coordinates: List[str]
    unit: str
    region: np.ndarray
    resolution: float
    working_modes: List[str]
    proved_count: int
    count_at_most: Optional[int]
    unresolved: List[Tuple[int, int]]
    measure_undecided: float
    seconds: float
    def locate(self, poses: Any, mode: str) -> np.ndarray: ...
    def boxes(self, aspect: int) -> np.ndarray: ...
    def undecided(self, mode: str) -> np.ndarray: ...
    def trace(self, mode: str, level: float, cells: int) -> Dict[str, Any]: ...
    def workspace(self, texts: Mapping[str, str], aspects: List[int], progress: Progress) -> List[Dict[str, Any]]: ...
    def plan(
        self, start: Any, goal: Any, start_mode: str, goal_mode: str, policy: str, prefer: str, progress: Progress
    ) -> Dict[str, Any]: ...
    def save(self, file: str) -> None: ...
