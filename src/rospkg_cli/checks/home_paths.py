"""Paths in one person's home folder that launch files, YAML, CMake and code name: nobody else has them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ..files import PackageFiles
from ..languages.python.file import PythonFile
from ..languages.python.guarded_nodes import is_guarded
from ..languages.python.unreached_places import is_unreached
from ..light_dataclasses import dataclass, replace
from ..package.file_role import is_set_aside, role_of
from ..package.install_table import InstallTable
from ..package.launch.launch_file import LaunchFile
from ..package.package_facts import PackageFacts
from ..package.params.parameter_file import ParameterFile
from ..package.workspace import Workspace
from ..source import Span
from ..unreadable import READABLE
from .cpp.uncalled_members import is_in_uncalled
from .idle_paths import IdlePaths
from .launch.missing_references import LaunchContext
from .launch.undeclared_files import is_written_in_vain
from .launch.unread_values import UnreadValues
from .launch.who_meets import level_met
from .left_files import LeftFiles
from .params.block_readers import BlockReaders
from .params.launch_overrides import is_given, is_overridden
from .params.path_readers import PathReaders
from .params.replaced_defaults import is_replaced
from .paths.bare_paths import names_nothing
from .paths.file_dialogs import begins_dialog
from .paths.home_path_texts import (
    ASKS,
    CPP,
    IS_SOUGHT,
    MARKUP,
    YAML,
    is_guarded_macro,
    is_in_handler,
    patterns,
    without_comments,
)
from .paths.shown_texts import is_only_shown
from .paths.written_paths import WrittenPaths
from .reached_definitions import ReachedDefinitions
from .repository.home_accounts import is_of_container, is_of_many
from .repository.replaced_launch_files import has_named_twin, is_always_given, is_named
from .repository.told_settings import is_told_by_comment, is_told_by_page
from .share_lookups import UNOPENED
from .unread_paths import UnreadPaths
from .unstarted_programs import UnstartedPrograms
from .yaml_elsewhere import is_named_yaml, is_of_another

FOR_CODE = ("launch", "src", "scripts", "script", "nodes", "node", "bin")


@dataclass(frozen=True, slots=True)
class HomePath:
    path: str
    """Of the file that names it."""
    span: Span
    text: str
    of_package: str | None
    """The package of the workspace in whose folders it lies."""
    below: str
    """The rest of the path, below that package or its share directory."""
    is_image: bool
    """Whether it is the image of a map."""
    may_be_there: bool
    """Whether many have an account of that name, or the container of the repository has; or code asks first whether
    it exists, tries another one first, or goes on where it can't be opened."""
    is_seldom_read: bool
    """Whether RViz, a script in a folder of its own, a file that nothing compiles, installs or starts, or YAML that
    nothing names, has it, or a program that nothing starts, beside others that are started; or a launch file whose
    callers give the argument, or whose twin in another language they name; or the parameter files of the package
    replace it; or it is one of several places for modules, a launch file has it that nothing uses, a comment or page
    tells to write another, a dialog for files begins there, or it has no suffix and is the path of no file or
    folder; or another machine is meant, or the default of a function that all calls replace."""
    is_unreached: bool = False
    """Whether it is in a function that nothing leads to."""
    is_unread: bool = False
    """Whether it is put into a variable, or is the default of an argument, that nothing reads."""
    is_written: bool = False
    """Whether it is shown to be a file that something writes."""
    is_unclaimed: bool = False
    """Whether it is a value of YAML, or of a parameter in a launch file, and neither code here nor a well-known node is
    shown to read it by its key."""
    is_last_resort: bool = False
    """Whether it is tried only where another way to the file failed before."""
    is_off: bool = False
    """Whether a switch that is off, or a default that chooses otherwise, keeps everything from coming to it."""


@dataclass(frozen=True)
class HomePaths:
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace
    table: InstallTable | None = None
    definitions: ReachedDefinitions | None = None
    unread: UnreadPaths | None = None
    left: LeftFiles | None = None
    programs: UnstartedPrograms | None = None
    idle: IdlePaths | None = None
    blocks: BlockReaders | None = None
    launches: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    parameters: Annotated[tuple[ParameterFile, ...], READABLE] = ()

    @cached_property
    def found(self) -> tuple[HomePath, ...]:
        """Each path once a file; those into this workspace first."""
        found = [each for path in self.files.paths if self.is_read(path) for each in self.of(path)]
        return tuple(sorted(found, key=lambda each: each.of_package is None))

    def is_read(self, path: str) -> bool:
        """Return whether a file is a launch file, YAML, CMake or code of what is built and runs."""
        if role_of(path) not in ("run", "launch"):
            return False
        read = (".py", *MARKUP, *YAML, *CPP, "CMakeLists.txt")
        return path.endswith(read) and not path.startswith((".", "build/", "install/", "log/"))

    def of(self, path: str) -> Iterator[HomePath]:
        if not any(self.files.holds(path, each) for each in (b"/home/", b"/Users/")):
            return
        text = self.files.readable_text(path)
        bare = without_comments(path, text)
        _, *halves = [without_comments(each, self.files.readable_text(each)) for each in self.halves(path)]
        is_asked = any(ASKS.search(each) for each in (bare, *halves))
        file, written = self.python(path), WrittenPaths(path, bare, *halves)
        places: dict[str, re.Match[str]] = {}
        for pattern in patterns(path):
            for match in pattern.finditer(bare):
                if not is_only_shown(path, bare, Span(*match.span("path")), file):
                    places.setdefault(match["path"], match)
        for named, match in sorted(places.items(), key=lambda each: each[1].start()):
            is_image = bare[: match.start("path")].rstrip(" \t\"'").endswith("image:")
            place, home = Span(*match.span("path")), self.home_of(named)
            is_asked_here = is_asked or (path.endswith(".py") and is_in_handler(bare, match.start()))
            is_asked_here = is_asked_here or (file is not None and is_guarded(file, place, UNOPENED))
            may_be_there = is_asked_here or self.is_of_many(match["user"] or match["mac"])
            if file is not None and is_unreached(file, place):
                continue
            is_seldom_read = self.is_seldom_read(path) or IS_SOUGHT.search(bare, 0, match.start()) is not None
            is_seldom_read = is_seldom_read or (path.endswith(YAML) and not is_image and not self.is_used(path))
            is_seldom_read = is_seldom_read or self.is_unused(path, place) or is_guarded_macro(bare, match.start())
            is_seldom_read = is_seldom_read or self.is_replaced(path, place, bare, named)
            is_seldom_read = is_seldom_read or self.is_given_otherwise(path, bare, place.start)
            is_seldom_read = is_seldom_read or self.is_setting(path, text, bare, place.start)
            is_seldom_read = is_seldom_read or self.is_told_for_all(match["user"] or match["mac"])
            is_seldom_read = is_seldom_read or begins_dialog(bare, place.start)
            is_seldom_read = is_seldom_read or (not is_image and self.names_nothing(path, *home))
            is_value = path.endswith((".yaml", ".yml")) and role_of(path) != "launch" and not is_image
            ends = self.is_unread(path, place), written.has(place) or (is_value and self.is_of_written(path, place))
            is_unclaimed = (is_value and not self.readers.has(path, place, bare)) or self.is_given_in_vain(path, place)
            from .paths.last_resorts import is_last_resort  # few files have such a path

            is_last = is_last_resort(path, bare, place, file)
            is_off = self.idle is not None and self.idle.has(path, place)
            is_seldom_read = is_seldom_read or (is_value and self.is_in_unread_block(path, place))
            flags = (is_image, may_be_there, is_seldom_read, self.is_unreached(path, place))
            found = HomePath(path, place, named, *home, *flags, *ends, is_unclaimed, is_last, is_off)
            yield replace(found, is_seldom_read=found.is_seldom_read or self.is_for_others(file, bare, place))

    def is_for_others(self, file: PythonFile | None, text: str, place: Span) -> bool:
        """Return whether a path is for another machine, or one that is chosen by its name, or each call gives one."""
        from .paths.chosen_machines import is_for_one_machine, is_on_another_host  # few files have such a path
        from .python.given_defaults import is_always_given as is_given_by_calls

        if file is None:
            return is_on_another_host(text, place.start)
        files = [each for _, each in self.definitions.run.files] if self.definitions is not None else []
        is_away = is_on_another_host(text, place.start) or is_for_one_machine(file, place)
        return is_away or is_given_by_calls(files, file, place)

    @cached_property
    def readers(self) -> PathReaders:
        return PathReaders(self.files, self.workspace, self.parameters)

    def names_nothing(self, path: str, package: str | None, below: str) -> bool:
        facts = self.workspace.named(package) if package is not None else None
        return names_nothing(path, below, self.files, self.facts, facts)

    def is_unreached(self, path: str, place: Span) -> bool:
        """Return whether no program of the package leads to the function around a place, or no C++ node names it."""
        sources = self.left.sources if self.left is not None and path.endswith(CPP) else ()
        if any(is_in_uncalled(each, place, sources) for each in sources if each.path == path):
            return True
        file = self.python(path)
        return file is not None and self.definitions is not None and not self.definitions.leads_to(file, place)

    def is_unread(self, path: str, place: Span) -> bool:
        """Return whether a place is that of a variable of code, or of a value of a launch file, that nothing reads."""
        if self.unread is not None and self.unread.has(path, place):
            return True
        if path.endswith(CPP) and self.left is not None:
            from .cpp.unread_texts import is_unread_text  # few files have such a path

            every = ((each.path, each.source.text) for each in self.left.sources)
            return is_unread_text(path, without_comments(path, self.files.readable_text(path)), place, every)
        return any(each.holds(place) for each in self.unread_values if each.scope.file.path == path)

    @cached_property
    def unread_values(self) -> tuple[UnreadValues, ...]:
        """What each launch file sets and nothing reads."""
        return tuple(map(UnreadValues, self.contexts))

    @cached_property
    def contexts(self) -> tuple[LaunchContext, ...]:
        rest = self.files, self.facts, self.workspace, self.table, None
        return tuple(LaunchContext(each, *rest) for each in self.launches)

    def is_given_in_vain(self, path: str, place: Span) -> bool:
        """Return whether a launch file has a place only for a parameter that no node is shown to read."""
        own = (each for each in self.contexts if each.file.path == path)
        return any(is_written_in_vain(each, place) for each in own)

    def is_replaced(self, path: str, place: Span, text: str, value: str) -> bool:
        """Return whether YAML or launch files give nodes another value in place of a default, or of that of a file."""
        before, launches = text[: place.start], self.launches
        if path.endswith(YAML) and role_of(path) != "launch":
            return is_overridden(path, place, self.parameters, launches)
        if role_of(path) == "launch":
            return is_always_given(path, before, self.files) or has_named_twin(path, self.files)
        return is_replaced(before, value, self.parameters) or is_given(before, value, self.facts.name, launches)

    def is_in_unread_block(self, path: str, place: Span) -> bool:
        """Return whether a place is in a block for a node that none is which launch files give the file to."""
        own = ((file, block) for file in self.parameters if file.path == path for block in file.blocks)
        held = ((file, block) for file, block in own if block.value.span.holds(place))
        return self.blocks is not None and any(self.blocks.is_unread(*each) for each in held)

    def is_of_written(self, path: str, place: Span) -> bool:
        from .paths.written_parameters import is_of_written  # few files have such a path

        return is_of_written(path, place, self.parameters, self.files)

    def is_given_otherwise(self, path: str, text: str, place: int) -> bool:
        """Return whether the build leaves a place out, or what is run gives another value than the one there."""
        from .cpp.undefined_macros import is_left_out  # few files have such a path
        from .repository.told_defaults import is_given_otherwise

        is_out = path.endswith(CPP) and is_left_out(text, place, self.files)
        return is_out or is_given_otherwise(path, text, place, self.files)

    def is_setting(self, path: str, text: str, bare: str, place: int) -> bool:
        """Return whether people are told to write a path of their own at a place."""
        is_script = self.left is not None and self.left.is_uninstalled(path)
        return is_told_by_comment(text, bare, place, is_script=is_script) or is_told_by_page(self.files, path)

    def python(self, path: str) -> PythonFile | None:
        return self.definitions.run.modules.at(path) if self.definitions and path.endswith(".py") else None

    def halves(self, path: str) -> Iterator[str]:
        """Yield a file and, of C++, the header or the source of its name: one may ask for what the other one names."""
        yield path
        stem = posixpath.splitext(posixpath.basename(path))[0]
        for other in self.files.paths if path.endswith(CPP) else ():
            if other != path and other.endswith(CPP) and posixpath.splitext(posixpath.basename(other))[0] == stem:
                yield other

    def is_of_many(self, user: str) -> bool:
        if user not in self.accounts:
            self.accounts[user] = is_of_many(user) or is_of_container(self.files, user)
        return self.accounts[user]

    def is_told_for_all(self, user: str) -> bool:
        if user not in self.told:
            from .repository.told_homes import is_told_for_all  # few files have such a path

            self.told[user] = is_told_for_all(self.files, user)
        return self.told[user]

    @cached_property
    def told(self) -> dict[str, bool]:
        """Whether people are to write their own home, for the accounts that were asked for."""
        return {}

    @cached_property
    def accounts(self) -> dict[str, bool]:
        """Whether many have an account, for those that were asked for."""
        return {}

    def is_seldom_read(self, path: str) -> bool:
        folder = path.partition("/")[0]
        is_aside = path.endswith(".py") and folder not in (self.facts.name, *FOR_CODE)
        is_left = self.left is not None and (
            self.left.has(path) or self.is_no_launch_file(path) or self.left.is_for_tests_alone(path)
        )
        is_left = is_left or (path.endswith(".py") and self.programs is not None and self.programs.has(path))
        is_aside = is_aside or is_set_aside(path) or (self.idle is not None and self.idle.is_of_idle_program(path))
        return path.endswith(".rviz") or is_aside or is_left or (path.endswith(YAML) and self.is_left_out(path))

    def is_no_launch_file(self, path: str) -> bool:
        """Return whether nothing installs a launch file, and nothing in the run names it: nobody starts it today."""
        if role_of(path) != "launch" or self.left is None or not self.left.is_uninstalled(path):
            return False
        return not self.left.is_named(path) and not is_named(path, self.files)

    def is_unused(self, path: str, place: Span) -> bool:
        """Return whether no launch comes to a place of a launch file: nothing adds it, or an end is before."""
        own = (each for each in self.launches if each.path == path)
        return any(level_met(each, place, self.workspace)[0] == "info" for each in own)

    def is_left_out(self, path: str) -> bool:
        """Return whether nothing installs a file."""
        table = self.table
        return table is not None and table.knows("share") and all(row.source != path for row in table.rows)

    def is_used(self, path: str) -> bool:
        """Return whether anything may give a YAML file to a node; a map is often given by hand."""
        rows = self.table.below(f"share/{self.facts.name}") if self.table is not None else ()
        places = [place for place, row in rows if row.source == path] or [path]
        is_named = is_named_yaml(path, self.facts, self.workspace)
        return is_named and not is_of_another(places, self.facts, self.workspace)

    def has(self, package: str, below: str) -> bool:
        """Return whether a package has a file or folder: this one in its sources, another one where it is installed."""
        facts = self.workspace.named(package)
        if facts is None or package == self.facts.name:
            return self.files.is_there(posixpath.normpath(below))
        return is_installed(below, facts)

    def home_of(self, named: str) -> tuple[str | None, str]:
        """Return the package of the workspace that a path leads into, and the rest; None where none is known."""
        folders = named.rstrip("/").split("/")[3:]
        into = [
            (name, "/".join(folders[start:]).removeprefix(f"share/{name}/"))
            for start in range(len(folders) - 1, 0, -1)
            if self.workspace.named(name := folders[start - 1]) is not None
        ]
        if into:  # the module of a package has its name too
            return next((each for each in into if self.has(*each)), into[0])
        for start in range(len(folders) - 1):
            rest = "/".join(folders[start:])
            if self.files.is_there(posixpath.normpath(rest)):
                return self.facts.name, rest
        return None, named


def is_installed(below: str, facts: PackageFacts) -> bool:
    """Return whether a path in the share directory of a package is that of a file, or of a folder of some."""
    return any(f"{each}/".startswith(f"{below}/") for each in facts.share_files)
