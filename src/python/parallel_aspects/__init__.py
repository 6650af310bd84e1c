# SPDX-License-Identifier: BSD-3-Clause
"""Where a parallel robot can move without meeting a singularity, with proofs: docs/python.md.

The messages of the package, parallel_aspects.msg, share this name; who imports those alone does not load the library.
"""

__all__ = [
    "Aspect",
    "BoundaryDistance",
    "Check",
    "Configuration",
    "Crossing",
    "DirectSolutions",
    "Distances",
    "InvalidDescription",
    "Map",
    "NOT_MAPPED",
    "OUTSIDE",
    "Path",
    "PathCrossing",
    "Robot",
    "Sweep",
    "UNDECIDED",
    "Workspace",
    "load",
    "read_sweep",
    "robots",
]


def __getattr__(name):
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import _api  # pylint: disable=import-outside-toplevel

    value = globals()[name] = getattr(_api, name)
    return value


def __dir__():
    return sorted(set(globals()) | set(__all__))
