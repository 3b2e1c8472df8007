"""Libraries of behavior-tree nodes that are compiled without the definition that exports them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.cpp.call import CppCall
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..cmake.source_targets import SourceTargets

MACRO = "BT_REGISTER_NODES"
DEFINITION = "BT_PLUGIN_EXPORT"
"""Without it the macro of bt_factory.h (BehaviorTree.CPP 3 and 4) makes a static function."""
REGISTERED = regex(r"\bregister(?:NodeType|Builder|SimpleAction|SimpleCondition)\b")
"""How code registers a node with a factory."""
FUNCTION = "BT_RegisterNodesFromPlugin"
QUOTED = regex(r'"[^"\\\n]+"')
NAMING = (".yaml", ".yml", ".py", ".xml", ".launch", ".md", ".rst", ".sh")
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
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace

    def is_loaded(self, target: str) -> bool:
        """Return whether a text of the package, but for CMake's, names a library, or a package needs this one.

        Such a package may have the list of libraries for navigation2, or a program that loads them.
        """
        if self.workspace.needing(self.facts.name):
            return True
        name = re.compile(rf"(?<![\w-])(?:lib)?{re.escape(target)}(?:\.so)?(?![\w./-])")
        texts = [self.files.readable_text(path) for path in self.files.paths if is_naming(path)]
        texts += [quoted for file in self.sources for quoted in QUOTED.findall(file.source.text)]
        return any(map(name.search, texts))

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
        """Whether code without the macro registers nodes: the package may not load its libraries at all."""
        others = (file.source.text for file in self.sources if not any(file.calls_to(MACRO)))
        return any(REGISTERED.search(text) for text in others)

    @property
    def is_exported(self) -> bool:
        in_cmake = any(DEFINITION in file.source.text for file in self.package.cmake.files)
        return in_cmake or any(DEFINITION in file.source.text for file in self.sources)


def is_naming(path: str) -> bool:
    """Return whether a file may name libraries for a program or for users to load."""
    is_run = role_of(path) not in ("test", "aside") and path != "package.xml"
    return is_run and path.endswith(NAMING)
