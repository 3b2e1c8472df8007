"""Rule input: what xacro makes of the robots of a package, and what is wrong with that, by file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from ...files import PackageFiles
from ...languages.xml.parser import Document
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.urdf.expansion.expander import Expander
from ...package.urdf.expansion.expansion import FoundProblem
from ...package.urdf.expansion.library import XacroLibrary
from ...package.urdf.expansion.macros import Macro
from ...package.workspace import Workspace
from ..fault import Fault
from .expanded_roots import split_faults
from .expanded_tree import ExpandedTree
from .xacro_calls import XacroCalls
from .xacro_problems import problem_fault

ROBOTS = (".xacro", ".urdf")
Callers = dict[int, list[str]]
"""The robots that call each macro, by the `id` of its element."""
RobotFault = tuple[str, str, Fault, Macro | None]
"""A robot, a file of the package, a fault that xacro meets there, and the macro that the robot does not call."""


@dataclass(frozen=True)
class ExpandedRobots:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    calls: XacroCalls

    def faults_of(self, path: str) -> list[tuple[str, Fault]]:
        """Return the faults in a file of the package, each with the robot in which xacro meets it."""
        return list(self.by_path.get(path, ()))

    @cached_property
    def by_path(self) -> Mapping[str, list[tuple[str, Fault]]]:
        """The faults by file; a fault in a macro counts for the robots that call the macro."""
        callers: Callers = {}
        every = sorted(self.every_fault(callers), key=lambda each: each[3] is not None)
        found: dict[str, list[tuple[str, Fault]]] = {}
        for robot, path, fault, macro in every:
            calling = callers.get(id(macro.element)) if macro is not None else [robot]
            softened = self.calls.in_macro(macro.name, fault) if macro is not None and not calling else fault
            found.setdefault(path, []).extend((each, softened) for each in calling or [robot])
        return found

    def every_fault(self, callers: Callers) -> Iterator[RobotFault]:
        """Yield all faults, and add the macros that each robot calls."""
        library = self.library
        documents = [document for path in self.paths if (document := library.read(path)) is not None]
        robots = [each for each in documents if each.root.tag == "robot"]
        reached: set[str] = set()
        for document in robots:
            if self.calls.includes.is_top(document):
                expander = Expander(library)
                yield from self.faults(expander, document, callers, is_robot=True)
                reached |= expander.found.reached
        for document in robots:
            if document.source.path not in reached:
                expander = Expander(library)
                expander.found.is_open = True
                yield from self.faults(expander, document, callers, is_robot=False)

    @cached_property
    def library(self) -> XacroLibrary:
        """The parsed documents; `callers` identifies their elements by `id`, so they must stay alive."""
        return XacroLibrary(self.files, self.package.name, self.workspace)

    @cached_property
    def paths(self) -> tuple[str, ...]:
        return tuple(
            path for path in self.files.paths if path.endswith(ROBOTS) and role_of(path) not in ("test", "aside")
        )

    def faults(
        self, expander: Expander, document: Document, callers: Callers, *, is_robot: bool
    ) -> Iterator[RobotFault]:
        """Expand a robot, then the macros that nothing called, and yield the faults in files of this package."""
        expansion, robot = expander.run(document), document.source.path
        for each in expander.called:
            callers.setdefault(each, []).append(robot)
        done = len(expansion.problems)
        tree = ExpandedTree(expansion, is_robot=is_robot)
        wrong = [*tree.faults()]
        for path, fault in wrong if wrong or done else split_faults(tree):
            yield robot, path, fault, None
        for path, fault in self.refused(expansion.problems, is_sure=is_robot):
            yield robot, path, fault, None
        for macro, pieces in expander.uncalled():
            for path, fault in ExpandedTree(pieces, is_robot=False).faults():
                yield robot, path, fault, macro
            for path, fault in self.refused(expansion.problems[done:], is_sure=False):
                yield robot, path, fault, macro
            done = len(expansion.problems)

    def refused(self, problems: Sequence[FoundProblem], *, is_sure: bool) -> Iterator[tuple[str, Fault]]:
        for problem in problems:
            fault = problem_fault(problem, self.calls, is_sure=is_sure)
            if fault is not None and not problem.source.path.startswith("/"):
                yield problem.source.path, fault
