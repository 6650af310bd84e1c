# SPDX-License-Identifier: BSD-3-Clause
"""Arguments as the texts, numbers and arrays that the compiled part takes, and what is said where they are none."""
import math
import operator
from typing import Any, ItemsView, Iterable, Mapping, Optional, Sequence, Union

import numpy as np

from ._core import InvalidDescription

Mode = Union[str, Sequence[int]]
Ranges = Union[str, Mapping[str, Sequence[float]]]
Values = Union[str, Mapping[str, float]]


def refused(problem: str) -> InvalidDescription:
    """An error with one problem."""
    error = InvalidDescription(problem)
    error.problems = [problem]
    return error


def array(name: str, values: "np.typing.ArrayLike") -> np.ndarray:
    """Numbers, whatever their shape."""
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise refused(f"{name} is no array of numbers; give rows of the same length, of finite numbers.") from None


def real(name: str, value: Optional[float]) -> Optional[float]:
    """A number, or None."""
    try:
        if value is None or not math.isnan(value):
            return None if value is None else float(value)
    except (TypeError, ValueError):
        pass
    raise refused(f"{name} is {value!r}; give a number.")


def count(name: str, value: int) -> int:
    """A whole number that is not negative, and no more than the compiled part holds."""
    try:
        if 0 <= operator.index(value) < 2**31:
            return operator.index(value)
    except TypeError:
        pass
    raise refused(f"{name} is {value!r}; give a whole number, not negative.")


def named(values: "Mapping[str, Any]") -> "ItemsView[str, Any]":
    """What a mapping holds."""
    if isinstance(values, Mapping):
        return values.items()
    raise refused(f'{values!r} does not name what it holds; give a mapping or a text, such as {{"x": 1}} or "x=1".')


def listed(values: Any) -> list:
    """What stands alone is a list of one."""
    return list(values) if isinstance(values, Iterable) else [values]


def number(value: float) -> str:
    """All digits of a number."""
    return repr(real("A value", value))


def varied_text(vary: "Union[str, Mapping[str, Union[float, Sequence[float]]]]") -> str:
    """ "crank_1=6:8:3 rod=1" for {"crank_1": (6, 8, 3), "rod": 1}; the third is how many values there are."""
    if isinstance(vary, str):
        return vary
    words = []
    for name, values in named(vary):
        parts = listed(values)
        counts = [str(count(f"The number of values of {name}", n)) for n in parts[2:]]
        words.append(f"{name}=" + ":".join([*map(number, parts[:2]), *counts]))
    return " ".join(words)
