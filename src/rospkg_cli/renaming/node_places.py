"""Where the files of a workspace start an executable of a package: launch files, tests, scripts."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..languages.python.file import PythonFile
from ..languages.python.syntax import parse
from ..source import Source, Span
from ..unreadable import UnreadableError
from .in_markup import EXECUTABLE as IN_TAG
from .in_markup import TAG
from .in_yaml import EXECUTABLE as IN_YAML
from .patterns import found
from .python_contexts import executables, run_by_command
from .python_literal import literal_span

COMMANDS = (r"\bros2\s+run\s+(?:-\S+\s+)*PACKAGE\s+%NAME%", r"\$\(exec-in-pkg\s+%NAME%\s+PACKAGE\s*\)")


def started_places(source: Source, package: str, name: str) -> Iterator[Span]:
    """Yield the name of an executable wherever a file starts it out of a package with a literal name."""
    word = re.escape(package)
    yield from found([each.replace("PACKAGE", word) for each in COMMANDS], source.text, name)
    if source.path.endswith(".py"):
        yield from in_python(source, package, name)
    elif source.path.endswith((".yaml", ".yml")):
        yield from found((IN_YAML.replace("%WORD%", word),), source.text, name)
    else:
        for tag in TAG.finditer(source.text):
            if re.search(rf"""\bpkg\s*=\s*["']{word}["']""", tag.group()):
                for span in found((IN_TAG,), tag.group(), name):
                    yield Span(tag.start() + span.start, tag.start() + span.end)


def in_python(source: Source, package: str, name: str) -> Iterator[Span]:
    try:
        file = PythonFile(source, parse(source))
    except UnreadableError:
        return
    for node in (*executables(file.tree, package, {name}), *run_by_command(file.tree, package, name)):
        if span := literal_span(file, node):
            yield span
