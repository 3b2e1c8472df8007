"""Names that `ament_export_libraries()` exports, and for which there is no library to link."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from .consumers import Consumers
from .name_slips import is_clear_slip, nearest
from .target_references import TargetReferences

NO_FILE = frozenset({"INTERFACE", "OBJECT"})


@dataclass(frozen=True)
class WrongExport:
    word: Word
    kind: Literal["executable", "no file", "unknown"]
    near: str = ""
    """The library that is intended by an unknown name; "" for one that is called like the package."""


@dataclass(frozen=True)
class ExportedLibraries:
    package: CMakePackage
    consumers: Consumers

    def wrong(self) -> Iterator[WrongExport]:
        """Yield each argument once; only clear slips where a file that can't be read may add targets."""
        cmake = self.package.cmake
        for each in self.every() if cmake.is_complete and self.package.is_ament else ():
            is_slip = each.kind == "unknown" and bool(each.near) and is_clear_slip(each.word.text, each.near)
            if is_slip or not cmake.reads_unknown_files:
                yield each

    def every(self) -> Iterator[WrongExport]:
        cmake = self.package.cmake
        seen: set[tuple[str, int, str]] = set()
        for call in cmake.named("ament_export_libraries"):
            for word in call.words:
                key = (word.path, word.span.start, word.text)
                if word.is_known and not word.maybe and not call.maybe and key not in seen:
                    seen.add(key)
                    yield from self.judged(word)

    def judged(self, word: Word) -> Iterator[WrongExport]:
        target = self.package.cmake.target(word.text)
        if target is None:
            yield from self.unknown(word)
        elif target.is_executable:
            yield WrongExport(word, "executable")
        elif target.is_library and target.options & NO_FILE and "IMPORTED" not in target.options:
            yield WrongExport(word, "no file")

    def unknown(self, word: Word) -> Iterator[WrongExport]:
        """Yield a name that no target has: that of a library of the system may be intended by any other one."""
        references = TargetReferences(self.package.cmake)
        cmake, name = self.package.cmake, word.text
        files = any(path.rpartition("/")[2].startswith(f"lib{name}.") for path in cmake.package_files.paths)
        if name in references.names or files or name in cmake.output_names.values():
            return
        libraries = {target.name for target in cmake.targets if target.is_library and target.is_built}
        near = nearest(name, libraries, 2)
        if near is not None or name == self.package.facts.name or self.is_called_like(name, libraries):
            yield WrongExport(word, "unknown", near or "")

    def is_lost(self, wrong: WrongExport) -> bool:
        """Return whether users get the library that is intended by no other export."""
        cmake = self.package.cmake
        exported = {word.text for call in cmake.named("ament_export_libraries") for word in call.words}
        targets = bool(cmake.exports) or any(rule.kind == "EXPORT" for rule in cmake.installs)
        return bool(wrong.near) and wrong.near not in exported and not targets

    def is_called_like(self, name: str, libraries: set[str]) -> bool:
        """Return whether a name begins like one of the package: with its own, or with that of a library of it.

        One of another package, as `moveit_core` has for `moveit_core_plugins`, may be exported.
        """
        found = {each.name for each in self.package.cmake.packages}
        starts = (name.startswith((f"{each}-", f"{each}_")) for each in (*libraries, self.package.facts.name))
        return any(starts) and len(libraries) > 0 and not any(name.startswith(each) for each in found)
