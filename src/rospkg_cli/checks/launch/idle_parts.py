"""Parts of a launch file that no launch reaches: functions that nothing calls, and entities that are switched off."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.unreached_functions import unreached_functions
from ...package.launch.asked_defaults import FALSE, TRUE
from ...package.launch.entity import Entity
from ...package.launch.launch_file import LaunchFile
from ...source import Span

ENTRY = "generate_launch_description"
SWITCHED_OFF = {"if": FALSE, "unless": TRUE}
"""The texts with which a condition never holds, in lower case."""


def idle_parts(file: LaunchFile, *, is_imported: bool) -> Iterator[Span]:
    """Yield the parts; the functions of a file that another one imports may be called there."""
    if file.python is not None and not is_imported:
        for each in unreached_functions(file.python, {ENTRY}):
            yield file.python.span(each)
    if file.root is not None:
        yield from switched_off(file.root)


def switched_off(entity: Entity) -> Iterator[Span]:
    for name, texts in SWITCHED_OFF.items():
        written = entity.attributes.get(name)
        if written is not None and written.text.strip().lower() in texts:
            yield entity.span
            return
    for child in entity.children:
        yield from switched_off(child)
