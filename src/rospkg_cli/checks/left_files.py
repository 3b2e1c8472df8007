"""Rule input: files of code and launch files that no build, program, page or other file of a package leads to."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ..files import PackageFiles
from ..languages.cpp.file import CppFile
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.file_role import role_of
from ..package.install_table import InstallKind, InstallTable
from ..package.launch.live_text import MARKUP as XML
from ..package.launch.live_text import live_text
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from ..unreadable import READABLE
from .depends.compiled_sources import sources_by_use
from .launch.left_launch_files import is_given_up
from .paths.home_path_texts import CPP, MARKUP, without_comments
from .python.plain_scripts import is_plain_script
from .python.unrun_tests import is_unregistered
from .reached_definitions import is_collected
from .reached_modules import NAMING, PAGES, SCRIPTS, ReachedModules
from .repository.linked_build import build_texts
from .repository.pages_and_scripts import pages_and_scripts

KINDS: tuple[InstallKind, ...] = ("executable", "share", "module", "other")
ENTRY = regex(r"(?m)^def generate_launch_description\b")
SETS_BIT = regex(r"(?m)^[^\n]*\bchmod\b[^\n]*$")
"""A line that starts nothing."""
BESIDE = ("CMakeLists.txt", ".cmake", "Makefile")


@dataclass(frozen=True)
class LeftFiles:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
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
        if is_collected(path) and not self.is_swept(path):
            return False
        if self.is_bare_description(path):
            return True
        if path.endswith(".py") and self.reached is not None and self.reached.is_left(path):
            return not self.is_for_others(path)
        is_left = self.is_uninstalled(path) and not (is_launch and self.are_launch_files_forgotten)
        is_left = is_left or self.is_no_program(path) or self.is_swept(path) or self.is_given_up(path)
        return (is_left or self.is_no_more_than_data(path)) and not self.is_named(path)

    def is_bare_description(self, path: str) -> bool:
        """Return whether a launch description lies among the modules, where `ros2 launch` finds it by its path alone,
        and nothing imports or names it, but to set its bit.
        """
        reached, table = self.reached, self.table
        if not path.endswith(".py") or role_of(path) != "run" or reached is None or table is None:
            return False
        rows, text = [row for row in table.rows if row.source == path], self.files.readable_text(path)
        is_module = bool(rows) and all(row.what == "module" for row in rows)
        if not is_module or ENTRY.search(text) is None or "__main__" in text or reached.has(path):
            return False
        name, word = reached.installed.names.get(path, ""), naming(path)
        taken = {each for facts in self.workspace.packages for each in facts.taken_names}
        if any(name in (module, f"{module}.{inner}") for module, inner in taken):
            return False
        return not any(word.search(SETS_BIT.sub("", self.live(each))) for each in self.having(word, path))

    def is_for_tests_alone(self, path: str) -> bool:
        """Return whether a script is called like a test and has none: pytest imports it, and nothing else here does."""
        if self.reached is None or not is_collected(path) or not self.reached.is_left(path):
            return False
        return self.is_script(path) and not self.is_for_others(path)

    def is_script(self, path: str) -> bool:
        file = self.reached.run.modules.at(path) if self.reached is not None else None
        return file is not None and is_plain_script(file)

    @cached_property
    def entries(self) -> frozenset[str]:
        """The files of the modules that entry points name: one that is not installed is meant to be started."""
        rows = self.table.of("executable") if self.table is not None else ()
        modules = (row.entry.partition(":")[0] for row in rows if row.entry)
        return frozenset(f"{module.replace('.', '/')}.py" for module in modules)

    @cached_property
    def are_launch_files_forgotten(self) -> bool:
        """Whether no launch file is installed: they are forgotten, and not left, unless pages start the programs."""
        if any(role_of(path) == "launch" for path in self.installed):
            return False
        started = re.compile(rf"ros2 +run +{re.escape(self.package.name)} ")
        return not any(map(started.search, pages_and_scripts(self.files)))

    def is_for_others(self, path: str) -> bool:
        """Return whether a package that needs this one has modules, which may import a module: no script is for them,
        unless they do.
        """
        users = [each for each in self.workspace.needing(self.package.name) if each.modules]
        if not users or self.reached is None or not self.is_script(path):
            return bool(users)
        name = self.reached.installed.names.get(path, "")
        taken = {taken for each in self.workspace.packages for taken in each.taken_names}
        return any(name in (module, f"{module}.{inner}") for module, inner in taken)

    def is_uncompiled(self, path: str) -> bool:
        """Return whether no target compiles a source, nor a file that includes it, beside others that are compiled."""
        return self.cmake is not None and sources_by_use(self.cmake, self.sources)[0].is_left(self.cmake, path)

    def is_uninstalled(self, path: str) -> bool:
        """Return whether no rule installs a file; XML is no program, and launch looks into share directories alone."""
        table = self.table
        installed = self.shared if path.endswith(XML) else self.installed
        return table is not None and all(map(table.knows, KINDS)) and path not in installed

    def is_no_more_than_data(self, path: str) -> bool:
        """Return whether a script is at most a part of a folder of data, where `ros2 run` and imports find it not.

        Where some rules to install are not known, it is one that lies in no folder that the build names.
        """
        if self.table is None or not path.endswith(".py") or role_of(path) != "run":
            return False
        rows = [row for row in self.table.rows if row.source == path]
        if rows or self.is_uninstalled(path):
            return all(row.what in ("share", "other") for row in rows)
        folders = "|".join(map(re.escape, posixpath.dirname(path).split("/")))
        word = re.compile(rf"(?<![\w-])(?:{folders})(?![\w-])")
        return bool(folders) and not any(
            word.search(self.live(each)) for each in self.files.matching("*CMakeLists.txt")
        )

    @cached_property
    def installed(self) -> frozenset[str]:
        return frozenset(row.source for row in self.table.rows) if self.table is not None else frozenset()

    def is_given_up(self, path: str) -> bool:
        """Return whether nobody means to start a launch file, no file names it, and no other package includes one."""
        if not is_given_up(path, self.files) or any(True for _ in self.having(naming(path), path)):
            return False
        name, others = posixpath.basename(path), self.workspace.packages
        summaries = (each for facts in others if facts.name != self.package.name for each in facts.launch_summaries)
        return not any(name in each.includes for each in summaries)

    @cached_property
    def shared(self) -> frozenset[str]:
        rows = self.table.rows if self.table is not None else ()
        return frozenset(row.source for row in rows if row.destination.startswith("share/"))

    def live(self, path: str) -> str:
        """Return what a file says: a page in all its text, any other file without comments."""
        if path.endswith(CPP):
            return without_comments(path, self.files.readable_text(path))
        return self.files.readable_text(path) if path.endswith(PAGES) else live_text(self.files, path)

    def is_no_program(self, path: str) -> bool:
        """Return whether setup.py puts a file among the programs, and `ros2 run` does not find it: it has no bit."""
        rows = [row for row in self.table.rows if row.source == path] if self.table is not None else []
        is_data = bool(rows) and all(row.what == "executable" and not row.entry for row in rows)
        is_data = is_data and all(row.path == "setup.py" for row in rows) and not self.files.is_executable(path)
        return is_data and SCRIPTS.search(self.files.readable_text("setup.py")) is None  # that sets the bit

    def is_swept(self, path: str) -> bool:
        """Return whether a script only came with its folder, among programs or data: it has no bit, and no `#!`."""
        rows = [row for row in self.table.rows if row.source == path] if self.table is not None else []
        is_data = bool(rows) and all(row.what in ("share", "other", "executable") and not row.entry for row in rows)
        is_data = is_data and all(row.path != "setup.py" for row in rows)  # setuptools sets the bit of `scripts`
        is_plain = is_data and path.endswith(".py") and not self.files.is_executable(path)
        return is_plain and role_of(path) == "run" and not self.files.readable_text(path).startswith("#!")

    def is_named(self, path: str) -> bool:
        """Return whether a file of the package, or of what builds the repository, leads to a file by its name.

        A module that nothing leads to leads nowhere.
        """
        found, waiting = {path}, [path]
        while waiting:
            one = waiting.pop()
            word = naming(one)
            if any(map(word.search, self.build_texts)):
                return True
            for each in self.having(word, one):
                if not self.may_be_left(each):
                    return True
                waiting += [each] if each not in found else []
                found.add(each)
        return False

    @cached_property
    def build_texts(self) -> tuple[str, ...]:
        return tuple(build_texts(self.files))

    def having(self, word: re.Pattern[str], path: str) -> Iterator[str]:
        """Yield the other files that have the name of one; what setup.py installs it names without a use."""
        ends, without = (*PAGES, *NAMING, *BESIDE, *CPP), {path, "setup.py"} if path in self.installed else {path}
        others = (each for each in self.files.paths if each not in without and each.endswith(ends))
        named = (each for each in others if word.search(self.files.readable_text(each)))
        return (each for each in named if word.search(self.live(each)))

    def may_be_left(self, path: str) -> bool:
        """Return whether a file is code that nothing installs, or a module that nothing starts or imports."""
        if not path.endswith(".py") or role_of(path) != "run" or is_collected(path):
            return False
        is_left = self.is_no_more_than_data(path) or (self.reached is not None and self.reached.is_left(path))
        return is_left and not self.is_for_others(path)


def naming(path: str) -> re.Pattern[str]:
    """Return how other files name a file: by its name, or as a module."""
    name = posixpath.basename(path)
    stem = re.escape(name.removesuffix(".py"))
    return re.compile(rf"(?<![\w-]){re.escape(name)}(?!\w)|(?<![\w-])(?:import|from)(?![\w-])[^\n]*(?<!\w){stem}(?!\w)")
