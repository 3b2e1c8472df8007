"""A launch file among the files that it names: those of its package, and what other packages install."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Literal

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_project import CMake
from ...package.cmake.named_files import mentions_file
from ...package.file_role import role_of
from ...package.install_table import InstallTable
from ...package.launch.file_references import OPEN, FileReference, ReferenceKind
from ...package.launch.launch_file import DeclaredArgument, LaunchFile
from ...package.launch.ros1 import is_named_ros1
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.well_known import other_launch_file
from ...source import Span
from ...suggest import slips
from ...unreadable import UnreadableError
from ..paths.closest_path import closest_path
from .open_paths import fits_nothing, meant

DOUBLED = regex(r"((?:\.[a-z][a-z0-9]*)+)\1(?=(?:\.[a-z]+)?$)")
"""An extension, or a part before one, that stands twice, which no file is given on purpose."""
USES: tuple[ReferenceKind, ...] = ("include", "open", "file", "default", "caught")
"""How a file is used, by how certain it is that the launch stops where it is missing."""
State = Literal["absent", "not installed", "elsewhere", "no slash"]


@dataclass(frozen=True, slots=True)
class MissingReference:
    """A file that is named and missing where it is looked for."""

    span: Span
    package: str
    path: str
    """Relative to the share directory of the package."""
    state: State
    use: ReferenceKind
    better_path: str | None = None
    """The file with the closest path; or, for `elsewhere`, where the file is installed."""
    other_spans: tuple[Span, ...] = ()
    """Other places that name it."""
    is_well_known: bool = False
    """Whether it is in a well-known package, whose sources are not here."""
    better_package: str = ""
    """The package of the better path, where it is well-known."""

    @property
    def is_for_rviz(self) -> bool:
        """Whether RViz opens it, which starts with its default view where it is missing."""
        return self.path.endswith(".rviz")

    @property
    def stops_launch(self) -> bool:
        """Whether the launch itself certainly opens it."""
        return self.use in ("include", "open") and not self.is_well_known and OPEN not in self.path


@dataclass(frozen=True)
class LaunchContext:
    file: LaunchFile
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    table: InstallTable | None
    cmake: CMake | None

    @cached_property
    def places(self) -> tuple[str, ...]:
        """Where the file itself goes, relative to the share directory."""
        rows = self.table.below(f"share/{self.package.name}") if self.table is not None else ()
        return tuple(path for path, row in rows if row.source == self.file.path)

    @property
    def is_installed(self) -> bool:
        """Whether the file itself is installed, or may be: else it is only started by its path in the source."""
        return self.table is None or not self.table.knows("share") or bool(self.places)

    @cached_property
    def is_unused_test(self) -> bool:
        """Whether it is a test that CMake, which is all known, does not run."""
        test = role_of(self.file.path) == "test"
        is_known = self.cmake is not None and self.cmake.is_complete
        return test and is_known and self.cmake is not None and not mentions_file(self.cmake, self.file.path)

    def is_made_here(self, missing: MissingReference) -> bool:
        """Return whether the launch file writes it: a robot by xacro's `open_output`, an output of a command."""
        if missing.path.endswith((".urdf", ".sdf")) and "open_output(" in self.file.source.text:
            return True
        if missing.use == "include":
            return False
        from .outputs_of_commands import is_written  # most launch files name what is there

        return is_written(self.file.source, (missing.span, *missing.other_spans))

    @property
    def is_ros1_leftover(self) -> bool:
        """Whether the file is one for ROS 1 that a package for ROS 2 alone installs, by chance."""
        try:
            manifest = self.files.source("package.xml").text
        except UnreadableError:
            return False
        alone = self.package.build_type.startswith("ament") and "catkin" not in manifest.lower()
        alone = alone and not self.files.holds("CMakeLists.txt", b"catkin_package")
        return self.file.is_ros1 and not is_named_ros1(self.file.path) and bool(self.places) and alone

    @cached_property
    def overwritten_defaults(self) -> tuple[Span, ...]:
        """The defaults of the arguments that the file gives another value itself."""
        names = {text.literal for text in self.file.assigned}
        return tuple(defaults_of(each for each in self.file.arguments if each.name.literal in names))

    def is_overwritten(self, missing: MissingReference) -> bool:
        """Return whether every place that names a file is the default of an argument that gets another value."""
        return is_within(missing, self.overwritten_defaults)

    def missing(self) -> Iterator[MissingReference]:
        """Yield each file that is named and missing, once."""
        found: dict[tuple[str, str], list[MissingReference]] = {}
        for named in self.file.every_path if not (self.file.is_ros1 or self.is_unused_test) else ():
            ask = self.unfitting if named.is_open else self.missing_at
            missing = ask(named) if not self.file.catches_missing(named.span) else None
            if missing is not None:
                found.setdefault((missing.package, missing.path), []).append(missing)
        for first, *others in found.values():
            use = min((each.use for each in (first, *others)), key=USES.index)
            yield replace(first, use=use, other_spans=tuple(other.span for other in others if other.span != first.span))

    def missing_in_silence(self) -> Iterator[MissingReference]:
        """Yield each file that Python code opens, and that is missing, where the code goes on with nothing."""
        told = set()
        for named in self.file.caught_paths if not (self.file.is_ros1 or self.is_unused_test) else ():
            missing = self.missing_at(named) if named.package and not named.is_open else None
            key = (missing.package, missing.path) if missing is not None and missing.state == "absent" else None
            if missing is not None and key and key not in told:
                told.add(key)
                yield replace(missing, use="caught")

    def missing_at(self, named: FileReference) -> MissingReference | None:
        if not named.package:
            return self.local_missing(named)
        own = named.package == self.package.name
        facts = self.package if own else self.workspace.named(named.package)
        if facts is None and (better := DOUBLED.sub(r"\1", named.path)) != named.path:
            return MissingReference(named.span, named.package, named.path, "absent", named.use, better)
        if facts is None and named.use == "include" and (other := other_launch_file(named.package, named.path)):
            home, better = other
            return MissingReference(named.span, named.package, named.path, "absent", named.use, better, (), True, home)
        if facts is None or facts.may_write(named.path):
            return None
        if not facts.knows("share_files") and posixpath.dirname(named.path) not in facts.settled_folders:
            return self.slip_at(named, facts)
        there = named.path in facts.share_files
        if not named.has_slash:
            return MissingReference(named.span, facts.name, named.path, "no slash", named.use) if there else None
        if there or self.is_brought(facts, named.path) or (own and self.is_in_nested(named.path)):
            return None
        state, better_path = self.state(facts, named.path)
        return MissingReference(named.span, facts.name, named.path, state, named.use, better_path)

    def is_in_nested(self, path: str) -> bool:
        """Return whether the launch file is of a package inside of this one, of the same name, that has a file."""
        folder = posixpath.dirname(self.file.path)
        while folder and not self.files.has_file(f"{folder}/package.xml"):
            folder = posixpath.dirname(folder)
        if not folder or not self.files.is_there(f"{folder}/{path}"):
            return False
        return f"<name>{self.package.name}</name>" in self.files.readable_text(f"{folder}/package.xml")

    def unfitting(self, named: FileReference) -> MissingReference | None:
        """Return a file of which a part is not known, where none can be meant."""
        own = named.package == self.package.name
        facts = self.package if own else self.workspace.named(named.package)
        if facts is None or not fits_nothing(named, facts, self.files, own=own):
            return None
        better = meant(named.path, facts.share_files)
        return MissingReference(named.span, facts.name, named.path, "absent", named.use, better)

    def slip_at(self, named: FileReference, facts: PackageFacts) -> MissingReference | None:
        """Return a file whose name is a slip of one that is installed beside it, where others may be installed too."""
        folder, name = posixpath.split(named.path)
        beside = [posixpath.basename(path) for path in facts.share_files if posixpath.dirname(path) == folder]
        single = DOUBLED.sub(r"\1", name)
        near = [single] if single in beside else slips(name, beside)
        near = near if named.has_slash and name not in beside else []
        if len(near) != 1 or self.is_brought(facts, named.path) or self.state(facts, named.path)[0] != "absent":
            return None
        meant = posixpath.join(folder, near[0])
        return MissingReference(named.span, facts.name, named.path, "absent", named.use, meant)

    def is_brought(self, facts: PackageFacts, path: str) -> bool:
        """Return whether a build, a submodule, or a program of the package may bring a file of it."""
        if path in facts.run_time_files:
            return True
        if facts is self.package:
            return self.files.absent.is_expected(path)
        return self.files.absent_in(facts.folder).is_ignored(path)

    def state(self, facts: PackageFacts, path: str) -> tuple[State, str | None]:
        if facts is self.package and self.files.is_there(path):
            goes = self.goes_to(path)
            return ("elsewhere", goes) if goes else ("not installed", None)
        if path in facts.uninstalled:
            return "not installed", None
        own = (self.file.path, *self.places) if facts is self.package else ()  # a file that includes itself never ends
        return "absent", closest_path(path, [each for each in facts.share_files if each not in own])

    def goes_to(self, path: str) -> str | None:
        """Return where a file of the package goes below the prefix."""
        return self.table.destination_of(path) if self.table is not None else None

    def local_missing(self, named: FileReference) -> MissingReference | None:
        """Return a missing file that is named relative to the launch file, in the source and where it is installed."""
        if self.files.is_there(named.path) or self.package.may_write(named.path):
            return None
        if not self.package.knows("share_files") or self.files.absent.is_expected(named.path):
            return None
        away = posixpath.relpath(named.path, posixpath.dirname(self.file.path) or ".")
        for place in self.places:
            if posixpath.normpath(posixpath.join(posixpath.dirname(place), away)) in self.package.share_files:
                return None
        better_path = closest_path(named.path, [each for each in self.files.paths if each != self.file.path])
        return MissingReference(named.span, self.package.name, named.path, "absent", named.use, better_path)


def defaults_of(arguments: Iterable[DeclaredArgument]) -> Iterator[Span]:
    """Yield where the defaults of arguments are written."""
    for each in arguments:
        if each.default is not None and each.default.parts:
            spans = (each.default.span, *(part.span for part in each.default.parts))
            yield Span(min(span.start for span in spans), max(span.end for span in spans))


def is_within(missing: MissingReference, around: Iterable[Span]) -> bool:
    """Return whether every place that names a file is one of some defaults, and none is given to a node as well."""
    spans = (missing.span, *missing.other_spans)
    inside = all(any(d.contains(span) for d in around) for span in spans)
    return inside and missing.use == "default"
