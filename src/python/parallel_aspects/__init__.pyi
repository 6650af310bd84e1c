# SPDX-License-Identifier: BSD-3-Clause
from ._api import (
    NOT_MAPPED as NOT_MAPPED,
    OUTSIDE as OUTSIDE,
    UNDECIDED as UNDECIDED,
    Aspect as Aspect,
    BoundaryDistance as BoundaryDistance,
    Check as Check,
    Configuration as Configuration,
    DirectSolutions as DirectSolutions,
    Distances as Distances,
    InvalidDescription as InvalidDescription,
    Map as Map,
    Path as Path,
    Roadmap as Roadmap,
    Robot as Robot,
    Sweep as Sweep,
    Workspace as Workspace,
    load as load,
    read_sweep as read_sweep,
    robots as robots,
)

__all__: list[str]
