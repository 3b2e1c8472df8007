"""Rule input: places that run only with a parameter or constant that is off, and that nothing sets."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ..files import PackageFiles
from ..languages.cpp.file import CppFile
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..source import Span
from ..tree import READABLE
from .python.run_imports import RunImports
from .python.switch import Switch

TELLING = (".md", ".rst", ".txt", ".sh", ".bash", ".service", ".env", ".toml", ".json", "Makefile", "Dockerfile")
"""Pages and scripts: it is enough that one names a parameter, as people may set it."""
SETTING = (".yaml", ".yml", ".xml", ".launch")
"""Files that set parameters, in addition to launch files in Python."""
VALUE = r"(?![\w-])(?:[\"']?\s*(?:[:=,]|\bvalue\s*=)\s*[\"']?(?P<said>false|true|0|1)\b)?"


@dataclass(frozen=True)
class UnsetSwitches:
    files: PackageFiles
    run: RunImports
    sources: tuple[CppFile, ...] = ()

    def why_off(self, path: str, span: Span) -> str:
        """Return the end of a message about a place that runs only with such a switch; "" for others."""
        for each in self.switches(path, span):
            if not any(self.is_set(name, each) for name in each.parameters):
                named = " and ".join(f"`{name}`" for name in each.parameters)
                what = f"the {each.kind} {named}" if named else f"`{each.variable}`"
                state = "on" if each.is_on else "off"
                return f"; it runs only where {what} is {state}, which it is not by default, and nothing here sets it"
        return ""

    def switches(self, path: str, span: Span) -> Iterator[Switch]:
        """Yield the switches that keep a place from running as long as nothing sets them."""
        file = self.run.modules.at(path) if path.endswith(".py") else None
        source = next((each for each in self.sources if each.path == path), None)
        if file is not None:
            from .python.python_switches import python_switches  # few packages lack what they look for

            yield from python_switches(file, span, [each for _, each in self.run.files])
        elif source is not None:
            from .cpp.switches_in_cpp import switches_in_cpp

            yield from switches_in_cpp(source, span, self.sources)

    def is_set(self, name: str, switch: Switch) -> bool:
        """Return whether a text of the repository gives a parameter another value than the default, or names it so."""
        last = name.rpartition(".")[2]
        word = re.compile(rf"(?<![\w-]){re.escape(last)}{VALUE}", re.IGNORECASE)
        for path in self.setting:
            is_there = self.whole.holds(path, last.encode())
            for found in word.finditer(self.whole.readable_text(path)) if is_there else ():
                is_default = found["said"] is not None and (found["said"].lower() in ("true", "1")) is not switch.is_on
                if not is_default or path.endswith(TELLING):
                    return True
        return False

    @cached_property
    def whole(self) -> PackageFiles:
        return PackageFiles(self.files.whole if self.files.whole is not None else self.files.tree)

    @cached_property
    def setting(self) -> tuple[str, ...]:
        """The files of the whole repository that may set a parameter."""
        return tuple(path for path, kind in self.whole.tree.files().items() if kind in READABLE and may_set(path))


def may_set(path: str) -> bool:
    is_setting = path.endswith((*TELLING, *SETTING)) or role_of(path) == "launch"
    return is_setting and not path.endswith(("CMakeLists.txt", "package.xml"))
