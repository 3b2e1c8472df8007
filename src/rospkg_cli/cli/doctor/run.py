"""`rospkg doctor`: examine, and print as text or JSON."""

from __future__ import annotations

import json
import shutil
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from textwrap import wrap

from ...control_characters import visible
from .examine import examine
from .topic import Topic

LABEL = 13
"""Columns of the first column."""

MIN_WIDTH = 60


def doctor(paths: Sequence[Path] = (), format: str = "text") -> int:
    """Print what decides about a lint of some paths (the current folder, if none); return the exit status.

    That is 1 where something keeps lint from running as it should. Raises LocateError where there is no such path.
    """
    topics = list(examine(tuple(paths) or (Path(),)))
    if format == "json":
        print(json.dumps({each.key: each.document() for each in topics}, indent=2))
    else:
        width = max(shutil.get_terminal_size((100, 24)).columns, MIN_WIDTH)
        sys.stdout.writelines(f"{line}\n" for line in shown(topics, width))
    return 1 if any(each.is_wrong for each in topics) else 0


def shown(topics: Iterable[Topic], width: int) -> Iterator[str]:
    """Yield the lines of the screen: the name of a topic before its first line, what to do about it after its last."""
    for topic in topics:
        label = f"{topic.name:<{LABEL}}"
        for line in [*topic.lines, *([f"→ {topic.advice}"] if topic.advice else [])]:
            for part in wrap(visible(line), width - LABEL, break_on_hyphens=False, break_long_words=False) or [""]:
                yield f"{label}{part}".rstrip()
                label = " " * LABEL
