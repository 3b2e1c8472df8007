"""What a Python file does before an import: it has pip install the module, or puts another object in its place."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of_kind
from ...lazy_regex import regex
from ..repository.own_environments import REFUSES
from .installing_texts import names_in

CHECKS = regex(
    r"(?i)(?:pip_?)?install\w*|\w*(?:check|ensure|install|require)\w*(?:requirement|package|module|dep|pip)\w*"
)
"""Functions that look for the packages that they are given, and install them: `ensure_packages(["numpy"])`."""
RUNS = frozenset("run call check_call check_output Popen system popen getoutput main _main".split())
"""Functions that run a command, or pip itself."""
NAME = regex(r"(?<![\w./=:-])[A-Za-z][\w.-]*")
PIP_BEFORE = "; this file has pip install it before"
COMMENT = regex(r"(?m)(?:^|[ \t])#(.*)$")
STOOD_IN = "; this file puts something in its place before"
BY_PIP_HERE = "; this file says to install it by pip"


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


def named_in_text(file: PythonFile) -> Iterator[str]:
    """Yield the names that comments or the docstring of a file say to install by pip."""
    for line in (*COMMENT.findall(file.source.text), *(ast.get_docstring(file.tree) or "").split("\n")):
        if "pip" in line and "install" in line and not REFUSES.search(line):
            yield from names_in(file.path, line)


def is_stood_in(file: PythonFile, top: str, start: int) -> bool:
    """Return whether a file puts another object in the place of a module before a place: `sys.modules["x"] = …`."""
    stand_in = rf"\bsys\.modules(?:\[|\.setdefault\()\s*[\"']{re.escape(top)}[\"']\s*(?:\]\s*=(?!=)|,)"
    return re.search(stand_in, file.source.text[:start]) is not None
