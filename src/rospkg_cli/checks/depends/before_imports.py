"""What a file does before an import: it has pip install the module, or ends at a module that ROS 1 alone has."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator

from ...languages.python.file import Import, PythonFile
from ...languages.python.nodes import last_name, nodes_of_kind
from ...lazy_regex import regex
from ..repository.own_environments import REFUSES
from .pip_installs import names_in

CHECKS = regex(
    r"(?i)(?:pip_?)?install\w*|\w*(?:check|ensure|install|require)\w*(?:requirement|package|module|dep|pip)\w*"
)
"""Functions that ask for what they are told, and install it."""
RUNS = frozenset("run call check_call check_output Popen system popen getoutput main _main".split())
"""Functions that run a command, or pip itself."""
NAME = regex(r"(?<![\w./=:-])[A-Za-z][\w.-]*")
OF_ROS1 = frozenset(
    "actionlib dynamic_reconfigure moveit_commander rosbag rosgraph roslaunch rosmaster rosnode rosparam rosservice "
    "rostopic tf tf_conversions".split()
)
"""Modules of packages that no distribution of ROS 2 has, though some of them can be had for it by other ways."""
PIP_BEFORE = "; this file has pip install it before"
COMMENT = regex(r"(?m)(?:^|[ \t])#(.*)$")
STOOD_IN = "; this file puts something in its place before"
BY_PIP_HERE = "; this file tells to install it by pip"


def installed_before(file: PythonFile, start: int) -> Iterator[str]:
    """Yield the names that calls before a place have pip install."""
    for call in nodes_of_kind(file.tree, ast.Call):
        if file.span(call).start < start:
            texts = [each.value for each in ast.walk(call) if isinstance(each, ast.Constant)]
            words = [word for text in texts if isinstance(text, str) for word in NAME.findall(text)]
            name = last_name(call.func) or ""
            is_pip = name in RUNS and "install" in words and ("pip" in words or "pip3" in words or "main" in name)
            if is_pip or CHECKS.fullmatch(name):
                yield from words


def ros1_imports(imports: Iterable[Import]) -> Iterator[Import]:
    """Yield a file's imports of modules of ROS 1 that are not optional, of those that few have otherwise."""
    for each in imports:
        is_certain = not (each.is_optional or each.is_for_typing or each.is_local or each.level)
        if is_certain and each.module.partition(".")[0] in OF_ROS1:
            yield each


def told_by_text(file: PythonFile) -> Iterator[str]:
    """Yield the names that comments of a file, or what stands at its top, tell to install by pip."""
    for line in (*COMMENT.findall(file.source.text), *(ast.get_docstring(file.tree) or "").split("\n")):
        if "pip" in line and "install" in line and not REFUSES.search(line):
            yield from names_in(file.path, line)


def is_stood_in(file: PythonFile, top: str, start: int) -> bool:
    """Return whether a file itself puts something in the place of a module before it imports that."""
    stand_in = rf"\bsys\.modules(?:\[|\.setdefault\()\s*[\"']{re.escape(top)}[\"']\s*(?:\]\s*=(?!=)|,)"
    return re.search(stand_in, file.source.text[:start]) is not None
