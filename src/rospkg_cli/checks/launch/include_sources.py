"""Launch files that are included by the class for files of another kind: `PythonLaunchDescriptionSource('a.xml')`."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping

from ...languages.python.evaluate.values import Call
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of
from ...package.launch.python_to_text import text_of
from ...package.launch.text import Literal
from ...source import Span
from ..fault import Fault, Level

PYTHON, XML, YAML = (f"{each}LaunchDescriptionSource" for each in ("Python", "XML", "YAML"))
FRONTEND = "FrontendLaunchDescriptionSource"
READERS: Mapping[str, str] = {".py": PYTHON, ".xml": XML, ".yaml": YAML, ".yml": YAML}
"""The class that reads files of an ending; `.launch` may be of any kind."""
READ_AS: Mapping[str, str] = {PYTHON: "Python", XML: "XML", YAML: "YAML", FRONTEND: "XML or YAML"}


def source_faults(launch: EvaluatedLaunch) -> Iterator[Fault]:
    """Yield the wrong classes; a warning where the include has a condition."""
    tested = [call.span for call in launch.calls if call.get("condition") is not None]
    for call in launch.calls:
        name, file = class_of(call), included_file(call)
        reader = READERS.get(posixpath.splitext(file)[1], "")
        if reader and name in READ_AS and name != reader and (name != FRONTEND or reader == PYTHON):
            end = launch.file.source.text.find("(", call.span.start, call.span.end)
            message = f"`{name}` reads `{file}` as {READ_AS[name]}: the launch stops where it is included"
            level: Level | None = "warning" if any(span.contains(call.span) for span in tested) else None
            yield Fault(Span(call.span.start, max(end, call.span.start)), f"{message}; use `{reader}`", level)


def included_file(call: Call) -> str:
    """Return the name of the file that a class of sources is given; "" where its end is not known."""
    value = call.get("launch_file_path", 0) if class_of(call) in READ_AS else None
    parts = text_of(value).parts if value is not None else ()
    return posixpath.basename(parts[-1].text) if parts and isinstance(parts[-1], Literal) else ""
