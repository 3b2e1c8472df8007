"""rosidl_generate_interfaces(): the files that it lists, and the packages whose types they use."""

from __future__ import annotations

from collections.abc import Iterator

from ..change import NotUnderstoodError, Paste
from ..checks.interfaces.rosidl_dependencies import RosidlDependencies
from ..checks.interfaces.rosidl_targets import RosidlTargets
from ..edits.cmake_commands import literal_span
from ..edits.cmake_interfaces import add_interface_dependency, add_interface_file
from ..finding import Edit
from ..languages.cmake.values import Word
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.interfaces.interface_file import InterfaceFile
from ..package.package import Package
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from ..ros.distros import Targets
from ..source import Span
from .cmake_block import argument_removals, block_removals, put_before_installs
from .cmake_find import cmake_of
from .dependency import manifest_of
from .part import Operations

CALL = "rosidl_generate_interfaces"


def generated(package: Package) -> RosidlTargets:
    """Return the interfaces that code is generated from in a package."""
    return RosidlTargets(cmake_of(package), package.parts(InterfaceFile).good)


def dependencies(package: Package) -> RosidlDependencies:
    """Return what these interfaces depend on, without a look at other packages of the workspace."""
    facts = PackageFacts(manifest_of(package).name, package.folder)
    return RosidlDependencies(generated(package), facts, Workspace((facts,)), Targets())


@dataclass(frozen=True)
class ListedFile:
    """An interface file among those that are generated."""

    path: str

    def add(self, package: Package) -> Operations:
        """Return the edit, nothing where it is listed or found by a pattern; raises NotUnderstoodError."""
        cmake = cmake_of(package)
        if self.path in cmake.generated_interfaces:
            return ()
        if not cmake.named(CALL):
            return put_before_installs(cmake.root, self.call(cmake))
        targets = generated(package)
        [interface] = [each for each in targets.interfaces if each.path == self.path]
        edit = add_interface_file(targets, interface)
        if edit is None:
            raise NotUnderstoodError(
                f"the files of {CALL} are computed: put the line where they are listed, and run the command again",
                Paste("CMakeLists.txt", f'"{self.path}"'),
            )
        return (edit,)

    def call(self, cmake: CMake) -> str:
        """Return the call that generates this file alone."""
        taken = {target.name for target in cmake.targets}
        name = "${PROJECT_NAME}_interfaces" if cmake.project_name in taken else "${PROJECT_NAME}"
        return f'{CALL}({name}\n{cmake.root.indent}"{self.path}"\n)'

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the path, of the whole call where it lists nothing else."""
        cmake = cmake_of(package)
        for target in cmake.interface_targets:
            mine = [word for word in target.files if target.path_of(word) == self.path]
            if mine and len(target.files) == 1:
                command = target.call.command
                yield from block_removals(cmake.root, cmake.file(target.call.path).source.slice(command.span))
            for word in mine:
                yield from word_removals(cmake, word)


@dataclass(frozen=True)
class ListedPackage:
    """A package among the DEPENDENCIES of the call."""

    name: str
    users: tuple[str, ...] = ()
    """The files that are added with it."""

    def add(self, package: Package) -> Operations:
        """Return the edit, nothing where the files need it not, or a listed package passes it on."""
        needs = dependencies(package)
        for need in needs.unlisted():
            if need.package == self.name:
                edit = add_interface_dependency(needs.generated, need)
                if edit is None:
                    raise NotUnderstoodError(
                        f"the DEPENDENCIES of {CALL} are computed: put the name there, and run the command again",
                        Paste("CMakeLists.txt", self.name),
                    )
                return (edit,)
        return ()

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the name, nothing where another file uses its types."""
        targets = generated(package)
        others = [each for each in targets.interfaces if each.path not in self.users]
        if any(kind.package == self.name for each in others for kind in each.types):
            return
        for target in targets.cmake.interface_targets:
            words = [word for word in target.dependencies if word.text == self.name]
            for word in words:
                if len(target.dependencies) == 1:
                    yield from keyword_removal(targets.cmake, word)
                yield from word_removals(targets.cmake, word)


def word_removals(cmake: CMake, word: Word) -> Iterator[Operations]:
    """Yield the removal of a word where a file holds it literally, with the blanks before or behind it."""
    file = cmake.file(word.path)
    if literal_span(file.source, word.span, word.text) is None:
        return
    yield from argument_removals(file, word.span)


def keyword_removal(cmake: CMake, word: Word) -> Iterator[Operations]:
    """Yield the removal of `DEPENDENCIES name`, with the line end and the blanks before it."""
    file = cmake.file(word.path)
    before = file.source.text[: word.span.start].rstrip()
    if before.endswith("DEPENDENCIES"):
        start = len(before.removesuffix("DEPENDENCIES").rstrip())
        yield (Edit(file.path, Span(start, word.span.end), ""),)
