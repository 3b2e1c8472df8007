"""Commands of CMake that may make a Python module, or a file that is one."""

from __future__ import annotations

from itertools import pairwise

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...lazy_regex import regex
from ...package.cmake.made_paths import ASKS

MAKES = regex(
    r"add_custom_\w+|execute_process|configure_file|externalproject_\w+|fetchcontent_\w+|set_(?:target_)?propert\w+"
    r"|.*(?:pybind|nanobind|python3?_add|generate_(?!interfaces)|protobuf|swig|cython|boost_python|_py_|qt).*"
)
IDLE = ASKS - {"git", "hg"} | {"chmod", "whoami", "nproc", "cat"}
"""Programs that make no file; git may fetch some."""
RENAMING = frozenset({"OUTPUT_NAME", "PREFIX", "SUFFIX"})
"""Properties of a library by which Python finds it as a module."""


def may_make_modules(call: EvaluatedCommand) -> bool:
    texts = call.texts
    if call.name == "execute_process":
        programs = [after for before, after in pairwise(texts) if before == "COMMAND"]
        return not programs or not all(each.rpartition("/")[2] in IDLE for each in programs)
    if call.name == "configure_file":
        return any(".py" in each or "$" in each or "\0" in each for each in texts[:2])
    if call.name.startswith("set_"):
        return any(each in RENAMING or "$" in each or "\0" in each for each in texts)
    return bool(MAKES.fullmatch(call.name))
