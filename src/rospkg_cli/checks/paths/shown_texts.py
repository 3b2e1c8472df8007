"""Texts that are only shown to people: descriptions, help, and what is printed or logged; they name no file."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of_kind
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...source import Span
from .logged_texts import is_said

HELP = frozenset("help metavar epilog usage additional_constraints".split())
"""Keywords that every call of these names only shows."""
DESCRIBED = frozenset((
    "DeclareLaunchArgument", "ParameterDescriptor", "ArgumentParser", "add_argument_group", "add_parser",
    "add_subparsers", "setup",
))  # fmt: skip
"""What takes a `description=` that is for people."""
SAYS = frozenset({"LogInfo"})
CPP = (".cpp", ".cc", ".cxx", ".hpp", ".h")
IN_CPP = regex(
    r"\b(?:RCLCPP_|RCUTILS_LOG_|ROS_)(?:DEBUG|INFO|WARN|ERROR|FATAL)\w*\s*\([^;{}]*\Z"
    r"|\bstd::c(?:out|err|log)\s*<<[^;{}]*\Z|\bf?printf\s*\([^;{}]*\Z"
    r"|\.(?:description|additional_constraints)\s*=\s*\"\Z"
)
IN_CMAKE = regex(r"(?i)\bmessage\s*\([^()]*\Z")
IN_MARKUP = regex(r"(?:<arg\s[^<>]*\bdescription|<log\s[^<>]*\bmessage)\s*=\s*[\"']\Z")
IN_YAML = regex(r"(?m)^[ \t-]*(?:description|message)[ \t]*:[ \t]*[\"']?\Z")
REACH = 1000
"""Letters before a place in which its statement begins."""


def is_only_shown(path: str, text: str, place: Span, file: PythonFile | None) -> bool:
    """Return whether a place of a file is in a text that code only shows."""
    if file is not None:
        return is_said(file, place) or any(each.holds(place) for each in shown_spans(file))
    before = text[max(0, place.start - REACH) : place.start]
    if path.endswith(CPP):
        return IN_CPP.search(before) is not None
    if path.endswith("CMakeLists.txt"):
        return IN_CMAKE.search(before) is not None
    if role_of(path) != "launch":
        return False
    return (IN_YAML if path.endswith((".yaml", ".yml")) else IN_MARKUP).search(before) is not None


def shown_spans(file: PythonFile) -> Iterator[Span]:
    """Yield what a Python file gives as a description, as help, or to launch's log."""
    for call in nodes_of_kind(file.tree, ast.Call):
        name = last_name(call.func)
        if name in SAYS:
            yield file.span(call)
        for keyword in call.keywords:
            if keyword.arg in HELP or (keyword.arg == "description" and name in DESCRIBED):
                yield file.span(keyword.value)
    for assignment in nodes_of_kind(file.tree, ast.Assign):
        if any(isinstance(each, ast.Attribute) and is_for_people(each.attr) for each in assignment.targets):
            yield file.span(assignment.value)


def is_for_people(attribute: str) -> bool:
    return attribute in ("description", "additional_constraints")
