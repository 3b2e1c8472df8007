"""Rule input: what xacro makes of the robots of a package, and what is wrong with that, by file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from ...files import PackageFiles
from ...languages.xml.parser import Document
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.urdf.expansion.expander import Expander
from ...package.urdf.expansion.library import XacroLibrary
from ...package.workspace import Workspace
from ..fault import Fault
from .expanded_tree import ExpandedTree
from .xacro_calls import XacroCalls
from .xacro_problems import problem_fault

ROBOTS = (".xacro", ".urdf")
LEVELS = (None, "error", "warning", "info")


@dataclass(frozen=True)
class ExpandedRobots:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    calls: XacroCalls

    def faults_of(self, path: str) -> list[Fault]:
        """Return the faults in a file of the package, each place once."""
        return list(self.by_path.get(path, {}).values())

    @cached_property
    def by_path(self) -> Mapping[str, Mapping[tuple[int, int], Fault]]:
        found: dict[str, dict[tuple[int, int], Fault]] = {}
        for path, fault in self.every_fault():
            place = found.setdefault(path, {})
            key = fault.span.start, fault.span.end
            if key not in place or LEVELS.index(fault.level) < LEVELS.index(place[key].level):
                place[key] = fault
        return found

    def every_fault(self) -> Iterator[tuple[str, Fault]]:
        library = XacroLibrary(self.files, self.package.name, self.workspace)
        documents = [document for path in self.paths if (document := library.read(path)) is not None]
        robots = [each for each in documents if each.root.tag == "robot"]
        reached: set[str] = set()
        for document in robots:
            if self.calls.is_top(document):
                expander = Expander(library)
                yield from self.faults(expander, document, is_robot=True)
                reached |= expander.found.reached
        for document in robots:
            if document.source.path not in reached:
                expander = Expander(library)
                expander.found.is_open = True
                yield from self.faults(expander, document, is_robot=False)

    @cached_property
    def paths(self) -> tuple[str, ...]:
        return tuple(
            path for path in self.files.paths if path.endswith(ROBOTS) and role_of(path) not in ("test", "aside")
        )

    def faults(self, expander: Expander, document: Document, *, is_robot: bool) -> Iterator[tuple[str, Fault]]:
        """Expand a robot, then the macros that nothing called, and yield what is wrong in files of this package."""
        expansion = expander.run(document)
        count = len(expansion.problems)
        yield from ExpandedTree(expansion, is_robot=is_robot).faults()
        for pieces in expander.uncalled():
            yield from ExpandedTree(pieces, is_robot=False).faults()
        for index, problem in enumerate(expansion.problems):
            fault = problem_fault(problem, self.calls, is_sure=is_robot and index < count)
            if fault is not None and not problem.source.path.startswith("/"):
                yield problem.source.path, fault
