# SPDX-License-Identifier: BSD-3-Clause
"""Where a parallel robot can move without meeting a singularity, with proofs: docs/reference/python.md.

The messages of the package, parallel_aspects.msg, share this name; who imports those alone does not load the library. So
this file is there without the library, too, and says what to build.
"""

__all__ = [
    "Aspect",
    "BoundaryDistance",
    "Check",
    "Configuration",
    "DirectSolutions",
    "Distances",
    "InvalidDescription",
    "Map",
    "NOT_MAPPED",
    "OUTSIDE",
    "Path",
    "Roadmap",
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
    from importlib.util import find_spec  # pylint: disable=import-outside-toplevel

    if find_spec("._core", __name__) is None:
        raise ImportError(
            f"{__name__}.{name} is of the compiled module, which is not in {__path__[0]}. "
            "Build the package with -DPARALLEL_ASPECTS_PYTHON=ON."
        )
    from . import _api  # pylint: disable=import-outside-toplevel

    value = globals()[name] = getattr(_api, name)
    return value


def __dir__():
    return sorted(set(globals()) | set(__all__))
