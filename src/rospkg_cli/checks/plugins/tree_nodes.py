"""Libraries of behavior-tree nodes that are compiled without the definition that exports them."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cpp.call import CppCall
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ..cmake.source_targets import SourceTargets

MACRO = "BT_REGISTER_NODES"
DEFINITION = "BT_PLUGIN_EXPORT"
"""Without it the macro of bt_factory.h (BehaviorTree.CPP 3 and 4) makes a static function."""
REGISTERED = regex(r"\bregister(?:NodeType|Builder|SimpleAction|SimpleCondition)\b")
"""How code tells a factory of a node."""
FUNCTION = "BT_RegisterNodesFromPlugin"
LOADED = frozenset({"SHARED", "MODULE"})


@dataclass(frozen=True)
class UnexportedTreeNodes:
    """BT_REGISTER_NODES in a file, and a library that it is compiled into."""

    file: CppFile
    call: CppCall
    target: str


@dataclass(frozen=True)
class TreeNodeLibraries:
    package: CMakePackage
    sources: tuple[CppFile, ...]

    def unexported(self) -> Iterator[UnexportedTreeNodes]:
        """Yield the calls of the macro in libraries that are loaded; nothing where a file names the definition."""
        used = [(file, call) for file in self.sources for call in file.calls_to(MACRO)]
        cmake = self.package.cmake
        if not used or not cmake.is_complete or cmake.reads_unknown_files or self.is_exported or self.registers_itself:
            return
        for file, call in used:
            if FUNCTION not in file.source.text and not call.is_conditional:
                names = sorted(SourceTargets(cmake).targets_of(file.path))
                loaded = [name for name in names if (target := cmake.target(name)) and LOADED & target.options]
                if loaded:
                    yield UnexportedTreeNodes(file, call, loaded[0])

    @property
    def registers_itself(self) -> bool:
        """Whether code without the macro tells a factory of nodes: the package may not load its libraries at all."""
        others = (file.source.text for file in self.sources if not any(file.calls_to(MACRO)))
        return any(REGISTERED.search(text) for text in others)

    @property
    def is_exported(self) -> bool:
        in_cmake = any(DEFINITION in file.source.text for file in self.package.cmake.files)
        return in_cmake or any(DEFINITION in file.source.text for file in self.sources)
