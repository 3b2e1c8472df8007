"""Rule input: whether C++ of the package makes objects of a class by itself, so that nothing has to load it by name."""

from __future__ import annotations

import re
from functools import cached_property
from typing import Annotated

from ..languages.cmake.evaluated_command import path_in_package
from ..languages.cpp.code_text import code_text
from ..languages.cpp.file import CppFile
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.file_role import is_set_aside, role_of
from ..unreadable import READABLE
from .depends.compiled_sources import own_compiled

MAIN = regex(r"\bmain\s*\(")
PLAIN = regex(r"(?:::)?[A-Za-z_]\w*(?:::[A-Za-z_]\w*)*")
DERIVES = r"\b(?:class|struct)\s+[^:;{{}}]{{1,200}}:(?!:)[^;{{}}]{{0,300}}(?<![\w:]){0}(?![\w:])"
MAKES = (
    r"\b(?:make_shared|make_unique|allocate_shared)\s*<\s*{0}\s*[,>]|\bnew\s+{0}(?![\w:])"
    r"|(?<![\w:]){0}::make_(?:shared|unique)\s*\(|[;{{}}:]\s*(?:static\s+)?{0}\s+\w+\s*[;({{]"
)
"""By a call, or as a member or a variable of the class itself; what only points to one makes none."""
REGISTERS = r"\bregister(?:NodeType|Builder)\s*<\s*{0}\s*>"
"""How BehaviorTree.CPP is given the class of a node."""


@dataclass(frozen=True)
class MadeClasses:
    cmake: CMake | None = None
    sources: Annotated[tuple[CppFile, ...], READABLE] = ()

    def why_unloaded(self, name: str) -> str:
        """Return which source makes objects of a class, or derives from it, without its name; "" where none does."""
        for verb, form in (("makes it itself", MAKES), ("derives from it", DERIVES)):
            if path := self.having(form, name):
                return f"; `{path}` {verb}, and nothing here loads it by its name"
        return ""

    def maker(self, name: str) -> str:
        """Return the source that makes objects of a class; "" where none does."""
        return self.having(MAKES, name)

    def registering(self, name: str) -> str:
        """Return the source that registers a class as a node of behavior trees; "" where none does."""
        return self.having(REGISTERS, name)

    def having(self, form: str, name: str) -> str:
        """Return the first source with a form of code about a class."""
        pattern = re.compile(form.format(written(name))) if PLAIN.fullmatch(name) else None
        return next((path for path, text in self.texts if pattern is not None and pattern.search(text)), "")

    @cached_property
    def texts(self) -> tuple[tuple[str, str], ...]:
        """The code of the files that run, by their paths: no tests, and no `main()` that is in no program."""
        compiled = own_compiled(self.cmake, self.sources) if self.cmake is not None else None
        found = []
        for each in self.sources:
            is_run = role_of(each.path) == "run" and not is_set_aside(each.path)
            if is_run and (compiled is None or each.path in compiled):
                text = code_text(each.source.text)
                is_idle = each.path not in self.programs and MAIN.search(text) is not None
                found += [] if is_idle else [(each.path, text)]
        return tuple(found)

    @cached_property
    def programs(self) -> frozenset[str | None]:
        """The sources of programs."""
        targets = [each for each in self.cmake.targets if each.is_executable] if self.cmake is not None else []
        return frozenset(path_in_package(word.text, each.call.folder) for each in targets for word in each.sources)


def written(name: str) -> str:
    """Return how code may write the name of a class: with all, some or none of the namespaces around it."""
    *spaces, last = name.removeprefix("::").split("::")
    pattern = ""
    for each in spaces:
        pattern = f"(?:{pattern}{each}::)?"
    return f"(?:::)?{pattern}{last}"
