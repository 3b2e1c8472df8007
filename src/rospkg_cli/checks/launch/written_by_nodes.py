"""Missing files that a node writes: it gets the path as a parameter, and opens what that says for writing."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.file_role import role_of
from ...source import Span
from ..paths.home_path_texts import without_comments
from ..paths.written_by_programs import CPP
from ..paths.written_in_cpp import is_opened
from ..paths.written_paths import WORD
from .launch_context import LaunchContext
from .missing_reference import MissingReference, defaults_of
from .undeclared_files import names_at

KEPT = regex(
    r"(?m)^[ \t]*((?:self\.)?\w+)[ \t]*(?::[^=\n]+)?=[^\n=]*(?:\(\s*)?[\w.]*\bget_parameter\(\s*[\"']([\w.]+)[\"']"
)
"""A variable that holds a parameter."""
KEPT_IN_CPP = regex(
    r"\b(?P<set>\w+)\s*=[^;=]{0,200}\b(?:declare|get)_parameter(?:<[^;()]{0,80}>)?\(\s*\"(?P<name>[\w.]+)\""
    r"|\bget_parameter\(\s*\"(?P<asked>[\w.]+)\"\s*,\s*(?P<filled>\w+)\s*\)"
)
"""The same in C++: bound to what a call returns, or filled by it."""
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
        program = program_of(path)
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


def saved_for(scope: LaunchContext, missing: MissingReference) -> str:
    """Return that a program writes a missing file, which is the default of an argument for an output; else "".

    The launch file starts the program, with a value that is not known for a parameter that the program writes to.
    """
    saving = (each for each in scope.file.arguments if OUTPUT.fullmatch(each.name.literal or ""))
    defaults, places = tuple(defaults_of(saving)), (missing.span, *missing.other_spans)
    if missing.package != scope.package.name or not any(each.contains(at) for each in defaults for at in places):
        return ""
    for node in scope.file.nodes:
        given = ((name.literal or "", value.literal) for each in node.parameters for name, value in each.values)
        unknown = {name for name, value in given if name and value is None}
        program = node.executable.literal if node.executable is not None else None
        is_own = node.package is not None and node.package.literal == scope.package.name
        for path in writers(scope, unknown) if is_own and program else ():
            if program in (posixpath.basename(path), program_of(path)):
                return UNTIL_WRITTEN.format(path)
    return ""


def program_of(path: str) -> str:
    return posixpath.splitext(posixpath.basename(path))[0]


def writers(scope: LaunchContext, parameters: set[str]) -> Iterator[str]:
    """Yield the files of the package whose code opens the value of one of some parameters for writing."""
    for path in scope.files.paths if parameters else ():
        if not path.endswith((".py", *CPP)) or role_of(path) in ("test", "launch"):
            continue
        text = scope.files.readable_text(path)
        if "_parameter" in text and any(name in parameters for name in written_parameters(path, text)):
            yield path


def written_parameters(path: str, text: str) -> Iterator[str]:
    """Yield the parameters whose values code opens for writing."""
    if path.endswith(CPP):
        live = without_comments(path, text)
        for found in KEPT_IN_CPP.finditer(live):
            if is_opened(found["set"] or found["filled"], live):
                yield found["name"] or found["asked"]
        return
    for variable, parameter in KEPT.findall(text):
        if re.search(rf"\bopen\(\s*{re.escape(variable)}{WRITE_MODE}", text):
            yield parameter


def is_given(scope: LaunchContext, launch: str, program: str, missing: MissingReference) -> bool:
    """Return whether a launch file names a program and a file."""
    text = scope.files.readable_text(launch)
    return program in text and posixpath.basename(missing.path) in text
