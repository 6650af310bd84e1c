# SPDX-License-Identifier: BSD-3-Clause
"""Lists of fields, which the compiled part has of each question and answer, as documentation."""
from typing import Any

from . import _core


def documented(described: Any, name: str) -> Any:
    """Adds the fields of a question to the documentation of a function, whose keywords they are, or those of an answer to that
    of its class."""
    lines = [f"{field}: {text}{f' [{unit}]' if unit and isinstance(described, type) else ''}." for field, unit, text in _core.fields(name)]
    described.__doc__ += "\n\n" + "\n".join(lines)
    return described


def answer(holder: type) -> type:
    """Of the class that holds an answer."""
    return documented(holder, holder.__name__)
