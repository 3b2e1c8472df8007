"""Rule input: files that run in another Python than that of ROS, or in an environment of their own (DEP101)."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.python.python_imports import PackageImports
from ..python.other_interpreters import host_of, is_for_another_interpreter
from ..repository.own_environments import environment_told
from ..unstarted_programs import UnstartedPrograms

HOSTED = "; another interpreter than that of ROS runs this file"


@dataclass(frozen=True)
class OtherPythons:
    files: PackageFiles
    package: PackageFacts
    python: PackageImports
    programs: UnstartedPrograms | None = None

    def why_unseen(self, paths: Iterable[str]) -> str:
        """Return why some files can't import what rosdep installs, as the end of a message; "" where they may."""
        hosts = {self.host_around(path) for path in paths}
        if hosts and "" not in hosts:
            return f"; the program imports `{min(hosts)}`, whose Python brings its libraries and sees none of rosdep"
        if command := environment_told(self.files, self.package.name):
            return (
                f"; a page here has it run in an environment (`{command}`), which sees no library that rosdep installs"
            )
        return ""

    @cached_property
    def hosted(self) -> frozenset[str]:
        """The files that another interpreter runs: one inside of a program, or on a microcontroller."""
        return frozenset(each.path for each in self.python.files if is_for_another_interpreter(each.imports))

    def host_around(self, path: str) -> str:
        """Return a module that only a host has and that each program with a file imports at its start; "" for none.

        Of a file of no program it is what each file that imports it does.
        """
        if path in self.hosts or self.programs is None:
            return self.hosts.get(path, "")
        groups = [paths for paths in self.programs.of_programs.values() if path in paths] or self.importing(path)
        found = {min(filter(None, map(self.hosts.get, paths)), default="") for paths in groups}
        return "" if "" in found else min(found, default="")

    def importing(self, path: str) -> list[frozenset[str]]:
        """Return each file that imports the module of a file, with that file."""
        reached = self.programs.reached if self.programs is not None else None
        uses = reached.imports.uses.get(reached.installed.names.get(path, ""), []) if reached is not None else []
        return [frozenset({file.path, path}) for file, _ in uses]

    @cached_property
    def hosts(self) -> dict[str, str]:
        """A module that only a host (Blender, Isaac Sim) has, by the path of the file that imports it at its top."""
        found = ((each.path, host_of(one for one in each.imports if not one.is_local)) for each in self.python.files)
        return {path: host for path, host in found if host}
