# SPDX-License-Identifier: BSD-3-Clause
"""Arguments as the texts that the command takes."""
from typing import Iterable, Mapping, Sequence, Union

Mode = Union[str, Sequence[int]]
Ranges = Union[str, Mapping[str, Sequence[float]]]
Values = Union[str, Mapping[str, float]]


def number(value: float) -> str:
    """All digits of a number."""
    return repr(float(value))


def mode_text(mode: Mode) -> str:
    """ "(+,-)" for (1, -1); what is a text stays one."""
    if isinstance(mode, str):
        return mode
    signs = {1: "+", -1: "-"}
    return "(" + ",".join(signs.get(int(sign), "?") for sign in mode) + ")"


def modes_text(modes: "Union[None, str, Iterable[Mode]]") -> str:
    """ "(+,-) (-,+)" for some modes; None is all, an empty text."""
    if modes is None or isinstance(modes, str):
        return modes or ""
    return " ".join(map(mode_text, modes))


def ranges_text(ranges: "Union[None, Ranges]") -> str:
    """ "x=-1:1 y=0:2" for {"x": (-1, 1), "y": (0, 2)}."""
    if ranges is None or isinstance(ranges, str):
        return ranges or ""
    return " ".join(f"{name}={':'.join(map(number, ends))}" for name, ends in ranges.items())


def values_text(values: "Union[None, Values]") -> str:
    """ "x=1 y=2" for {"x": 1, "y": 2}."""
    if values is None or isinstance(values, str):
        return values or ""
    return " ".join(f"{name}={number(value)}" for name, value in values.items())


def words_text(words: "Union[None, str, Iterable[str]]") -> str:
    """ "count,measures" for ("count", "measures")."""
    return words or "" if words is None or isinstance(words, str) else ",".join(words)


def varied_text(vary: "Union[str, Mapping[str, Union[float, Sequence[float]]]]") -> str:
    """ "crank_1=6:8:3 rod=1" for {"crank_1": (6, 8, 3), "rod": 1}; the third is how many values there are."""
    if isinstance(vary, str):
        return vary
    words = []
    for name, values in vary.items():
        parts = list(values) if isinstance(values, Iterable) else [values]
        words.append(f"{name}=" + ":".join([number(end) for end in parts[:2]] + [str(int(n)) for n in parts[2:]]))
    return " ".join(words)
