# SPDX-License-Identifier: BSD-3-Clause
"""Lists of fields, which the compiled part has of each question and answer, as documentation."""
from typing import Any, Iterable, Tuple


def documented(described: Any, fields: Iterable[Tuple[str, str, str]]) -> None:
    """Adds the fields to the documentation of a function, whose keywords they are, or of what holds an answer."""
    lines = [f"{name}: {text}{f' [{unit}]' if unit and isinstance(described, type) else ''}." for name, unit, text in fields]
    described.__doc__ += "\n\n" + "\n".join(lines)
