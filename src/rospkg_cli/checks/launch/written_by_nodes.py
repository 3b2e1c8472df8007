"""Missing files that a node writes: it gets the path as a parameter, and opens what that says for writing."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.file_role import role_of
from ...source import Span
from ..paths.written_paths import WORD
from .launch_context import LaunchContext
from .missing_reference import MissingReference
from .undeclared_files import names_at

KEPT = regex(
    r"(?m)^[ \t]*((?:self\.)?\w+)[ \t]*(?::[^=\n]+)?=[^\n=]*(?:\(\s*)?[\w.]*\bget_parameter\(\s*[\"']([\w.]+)[\"']"
)
"""A variable that holds a parameter."""
WRITE_MODE = r"\s*,\s*(?:mode\s*=\s*)?[\"'][bt+]*[wxa]"
SAVERS = regex(r"(?i)(?:^|[_-])(?:saver|recorder|writer|exporter)(?:$|[_.-])")
"""Programs whose work it is to write a file."""
OUTPUT = regex(rf"(?i)(?!.*conf){WORD}")
UNTIL_WRITTEN = "until `{}` has written it"


def written_for(scope: LaunchContext, missing: MissingReference) -> str:
    """Return that a program writes a missing file, which launch hands to nodes; "" where none does.

    It is a program of the package that the launch file starts itself, or that another one gives a file of that name; or
    one whose code is not here and that is called after such work (`octomap_saver_node`), or whose parameter is.
    """
    if missing.package != scope.package.name or missing.use in ("include", "open"):
        return ""
    places = (missing.span, *missing.other_spans)
    given = {name for node in scope.file.nodes for place in places for name in names_at(node, place)} - {""}
    for path in writers(scope, given):
        program = posixpath.basename(path).removesuffix(".py")
        if any(is_given(scope, each, program, missing) for each in scope.files.paths if role_of(each) == "launch"):
            return UNTIL_WRITTEN.format(path)
    program = saver_of(scope, places)
    return UNTIL_WRITTEN.format(program) if program else ""


def saver_of(scope: LaunchContext, places: tuple[Span, ...]) -> str:
    """Return a program of elsewhere that is called after its writing, and gets the path as a parameter; else ""."""
    for node in scope.file.nodes:
        package = node.package.literal or "" if node.package is not None else ""
        if package == scope.package.name or scope.workspace.named(package) is not None:
            continue  # its code says what it writes
        program = node.executable.literal or "" if node.executable is not None else ""
        names = {name for place in places for name in names_at(node, place)} - {""}
        if program and ((names and SAVERS.search(program)) or any(map(OUTPUT.fullmatch, names))):
            return program
    return ""


def writers(scope: LaunchContext, parameters: set[str]) -> Iterator[str]:
    """Yield the Python files of the package that open the value of one of some parameters for writing."""
    for path in scope.files.paths if parameters else ():
        if not path.endswith(".py") or role_of(path) in ("test", "launch"):
            continue
        text = scope.files.readable_text(path)
        for variable, parameter in KEPT.findall(text) if "get_parameter" in text else ():
            opened = rf"\bopen\(\s*{re.escape(variable)}{WRITE_MODE}"
            if parameter in parameters and re.search(opened, text):
                yield path


def is_given(scope: LaunchContext, launch: str, program: str, missing: MissingReference) -> bool:
    """Return whether a launch file names a program and a file."""
    text = scope.files.readable_text(launch)
    return program in text and posixpath.basename(missing.path) in text
