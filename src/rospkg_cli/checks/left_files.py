"""Rule input: files of code and launch files that nothing builds, installs, starts, imports or names."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property
from typing import Annotated

from ..files import PackageFiles
from ..languages.cpp.file import CppFile
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.file_role import role_of
from ..package.install_table import InstallTable
from ..package.launch.live_text import MARKUP as XML
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from ..unreadable import READABLE
from .depends.sources_by_use import sources_by_use
from .file_mentions import FileMentions, naming
from .how_installed import HowInstalled
from .launch.left_launch_files import is_given_up
from .module_users import ModuleUsers
from .paths.home_path_texts import CPP, MARKUP
from .python.unrun_tests import is_unregistered
from .reached_definitions import is_collected
from .reached_modules import ReachedModules
from .repository.linked_build import build_texts
from .repository.pages_and_scripts import pages_and_scripts

ENTRY = regex(r"(?m)^def generate_launch_description\b")
SETS_BIT = regex(r"(?m)^[^\n]*\bchmod\b[^\n]*$")
"""A line that only makes a file executable, and does not start it."""


@dataclass(frozen=True)
class LeftFiles:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    how: HowInstalled
    mentions: FileMentions
    users: ModuleUsers
    table: InstallTable | None = None
    reached: ReachedModules | None = None
    cmake: CMake | None = None
    sources: Annotated[tuple[CppFile, ...], READABLE] = ()

    def has(self, path: str) -> bool:
        """Return whether nothing that is known compiles, installs, imports, starts or names a file."""
        if path.endswith(CPP):
            return self.is_uncompiled(path)
        if role_of(path) == "test" and path.endswith(".py") and self.package.build_type != "ament_python":
            return is_unregistered(path, self.cmake) and not self.is_named(path)
        is_launch = role_of(path) == "launch"
        ends = (".py", *(XML if is_launch else MARKUP))
        if not path.endswith(ends) or path in ("setup.py", *self.entries):
            return False
        if is_collected(path) and not self.how.is_swept(path):
            return False
        if self.is_bare_description(path):
            return True
        if path.endswith(".py") and self.reached is not None and self.reached.is_left(path):
            return not self.users.may_need(path)
        is_left = self.is_uninstalled(path) and not (is_launch and self.are_launch_files_forgotten)
        is_left = is_left or self.how.is_no_program(path) or self.how.is_swept(path) or self.is_given_up(path)
        return (is_left or self.how.is_no_more_than_data(path)) and not self.is_named(path)

    def is_bare_description(self, path: str) -> bool:
        """Return whether a launch description is installed as a Python module, where `ros2 launch` finds it only by its
        path, and nothing imports or names it, but to make it executable.
        """
        reached, table = self.reached, self.table
        if not path.endswith(".py") or role_of(path) != "run" or reached is None or table is None:
            return False
        rows, text = [row for row in table.rows if row.source == path], self.files.readable_text(path)
        is_module = bool(rows) and all(row.what == "module" for row in rows)
        if not is_module or ENTRY.search(text) is None or "__main__" in text or reached.has(path):
            return False
        name, word = reached.installed.names.get(path, ""), naming(path)
        if self.users.is_imported(name):
            return False
        having = self.mentions.having(word, path)
        return not any(word.search(SETS_BIT.sub("", self.mentions.live(each))) for each in having)

    def is_for_tests_alone(self, path: str) -> bool:
        """Return whether a script has the name of a test and holds none, so that only pytest imports it."""
        if self.reached is None or not is_collected(path) or not self.reached.is_left(path):
            return False
        return self.users.is_script(path) and not self.users.may_need(path)

    @cached_property
    def entries(self) -> frozenset[str]:
        """The files of the modules that entry points name, which may be started even where they are not installed."""
        rows = self.table.of("executable") if self.table is not None else ()
        modules = (row.entry.partition(":")[0] for row in rows if row.entry)
        return frozenset(f"{module.replace('.', '/')}.py" for module in modules)

    @cached_property
    def are_launch_files_forgotten(self) -> bool:
        """Whether all launch files lack an install rule by mistake: none is installed, and no page has `ros2 run`."""
        if any(role_of(path) == "launch" for path in self.how.installed):
            return False
        started = re.compile(rf"ros2 +run +{re.escape(self.package.name)} ")
        return not any(map(started.search, pages_and_scripts(self.files)))

    def is_uninstalled(self, path: str) -> bool:
        """Return whether no rule installs a file."""
        return self.how.is_uninstalled(path)

    def is_uncompiled(self, path: str) -> bool:
        """Return whether no target compiles a source, nor a file that includes it, while others are compiled."""
        return self.cmake is not None and sources_by_use(self.cmake, self.sources)[0].is_left(self.cmake, path)

    def is_given_up(self, path: str) -> bool:
        """Return whether a launch file is an old copy or still for ROS 1, and nothing names or includes it."""
        if not is_given_up(path, self.files) or any(True for _ in self.mentions.having(naming(path), path)):
            return False
        name, others = posixpath.basename(path), self.workspace.packages
        summaries = (each for facts in others if facts.name != self.package.name for each in facts.launch_summaries)
        return not any(name in each.includes for each in summaries)

    def is_named(self, path: str) -> bool:
        """Return whether a file of the package, or a script that builds the repository, names a file.

        A module that is itself not used does not count, unless something in use names that one.
        """
        found, waiting = {path}, [path]
        while waiting:
            one = waiting.pop()
            word = naming(one)
            if any(map(word.search, self.build_texts)):
                return True
            for each in self.mentions.having(word, one):
                if not self.may_be_left(each):
                    return True
                waiting += [each] if each not in found else []
                found.add(each)
        return False

    @cached_property
    def build_texts(self) -> tuple[str, ...]:
        return tuple(build_texts(self.files))

    def may_be_left(self, path: str) -> bool:
        """Return whether a file is code that nothing installs, or a module that nothing starts or imports."""
        if not path.endswith(".py") or role_of(path) != "run" or is_collected(path):
            return False
        is_left = self.how.is_no_more_than_data(path) or (self.reached is not None and self.reached.is_left(path))
        return is_left and not self.users.may_need(path)
