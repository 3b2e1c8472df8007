"""Rule input: parameters that files and launch files give, or code gets, and that no code declares (PRM007)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import Parameter, ParameterFile
from ..depends.compiled_sources import own_compiled
from ..depends.header_inclusions import HEADERS
from ..fault import Fault, Level
from ..repository.older_distribution import OlderDistribution
from .block_readers import BlockReaders
from .declaring_packages import ParameterContext
from .forgotten_declarations import ForgottenDeclarations
from .idle_nodes import hardest, level_of
from .joint_limits import JointLimits
from .known_given import KnownNodes
from .launch_overrides import is_intended_given
from .launched_names import LaunchedNames
from .other_variants import unlike_variants
from .parameter_group import ParameterGroup
from .parameter_reads import ParameterReads
from .repeated_reads import RepeatedRead, RepeatedReads
from .strange_names import strange_names, why_dropped
from .unknown_parameter_texts import repeated, undeclared
from .unknown_python_reads import unknown_python_reads
from .unknown_read import UnknownRead
from .unmet_reads import UnmetReads

MAY = ", unless the code here reads it otherwise"


@dataclass(frozen=True)
class UnknownParameters:
    """What files and launch files give and code gets, and what code declares (PRM007)."""

    given: ParameterContext
    reads: ParameterReads
    cmake: CMake | None
    forgotten: ForgottenDeclarations
    launched: LaunchedNames
    known: KnownNodes
    readers: BlockReaders
    joints: JointLimits
    distribution: OlderDistribution
    unmet: UnmetReads
    files: PackageFiles

    def unknown_reads(self) -> list[UnknownRead]:
        """Return what code that is compiled, or Python, gets and nothing declares, each place once."""
        found = list(unknown_python_reads(self.reads))
        if self.reads.cpp:
            from .unknown_cpp_reads import unknown_cpp_reads  # what packages in Python don't need

            found = [*unknown_cpp_reads(self.reads), *found]
        found += self.forgotten.all({(each.path, each.span.start) for each in found})
        compiled = own_compiled(self.cmake, self.reads.cpp) if self.cmake is not None else None
        sources = {file.path for file in self.reads.cpp if not file.path.endswith(HEADERS)}
        return [each for each in found if not compiled or each.path not in sources - compiled]

    def level_and_message(self, read: UnknownRead) -> tuple[Level, str]:
        """Return the level and the message of a parameter that code gets and nothing declares."""
        if self.distribution.is_before_dashing:
            return "info", f"{undeclared(read)}; before Dashing, which the pages name, none need be declared"
        if read.unless:
            return "info", f"{undeclared(read)}{read.unless}"
        if read.is_dropped:
            return "info", f"{undeclared(read)}; nothing reads the variable that gets it"
        if self.is_unmet(read):
            return "info", f"{undeclared(read)}; nothing here reaches this place"
        is_error = read.throws and read.suggestion and not read.on_request
        is_error = is_error and not self.unmet.is_seldom(read.path, read.span, self.reads.cpp)
        return "error" if is_error else "warning", undeclared(read)

    def is_unmet(self, read: UnknownRead | RepeatedRead) -> bool:
        """Return whether no program of the package reaches a place, as far as names show."""
        if read.path.endswith(".py"):
            return self.unmet.in_python(read.path, read.span)
        return self.unmet.in_cpp(read.path, read.span, self.reads.cpp)

    def why_unread(self, owners: Iterable[PackageFacts | None], name: str) -> str:
        """Return that no code of this package uses a parameter, where it alone declares it; "" where some may."""
        from .unread_parameters import is_unread_by  # few packages need it

        reads = self.reads
        is_own = bool(name) and all(each is not None and each.folder == reads.package.folder for each in owners)
        is_unread = is_own and is_unread_by(name, reads.package, reads.cpp, list(reads.run_files))
        return f", and nothing differs, as no code uses `{name}`" if is_unread else ""

    def why_harmless(self, group: ParameterGroup, parameter: Parameter, intended: str) -> str:
        """Return why losing a value under an unknown name changes nothing, or what may read it; "" for neither."""
        if intended and is_intended_given(group.file.path, intended, self.known.launched.launches):
            return f", and nothing differs, as launch files give `{intended}`"
        may = next(filter(None, (self.may_read(each, parameter.name, intended) for each in group.owners)), "")
        return group.same_as_default(parameter, intended) or self.why_unread(group.owners, intended) or may

    def may_read(self, owner: PackageFacts | None, name: str, intended: str) -> str:
        """Return that code of this package may read the name, where the package declares it; else ""."""
        from .open_code import OpenCode  # few packages need it

        is_own = owner is not None and owner.folder == self.reads.package.folder and bool(intended)
        return MAY if is_own and OpenCode(self.reads).may_read(name, intended) else ""

    def hint(self, owner: PackageFacts | None, name: str, intended: str, path: str) -> str:
        """Return a hint on an unknown name: the intended one, or that the tests of the declaring package use it too."""
        from .names_in_tests import is_in_tests  # few packages need it

        if owner is not None and is_in_tests(self.files, owner, name, intended, path):
            return f"the tests of `{owner.name}` have `{name}` too, so that its `{intended}` may be the slip"
        return f"did you mean `{intended}`?"

    def repeated_reads(self) -> Iterator[tuple[str, Fault]]:
        """Yield path and fault of what is got twice, the second time in the place of what no code gets."""
        for each in RepeatedReads(self.forgotten).all():
            yield each.path, Fault(each.span, repeated(each), "info" if self.is_unmet(each) else None)

    def unlike_variants(self) -> list[tuple[ParameterFile, Parameter, str, str]]:
        """Return the names in whose place another file of the same name has a declared one; without reported ones."""
        reported = {(group.file.path, each.key.span) for group in self.given.groups() for each, _ in group.unknown()}
        found = {(each[0].path, each[1].key.span): each for each in unlike_variants(self.given)}
        return [each for place, each in found.items() if place not in reported]

    def strange_names(self) -> Iterator[tuple[str, Fault]]:
        """Yield path and fault of the names that no node has, each place once."""
        found = strange_names(self.known.launched)
        for each in hardest(((one.path, one.span), one) for one in found):
            softer, why = level_of(each.start)
            is_mild = softer == "info" or bool(each.same) or self.readers.is_idle(each.path, each.span)
            lost = each.same or f", and {why_dropped(each.name, each.intended)}"
            what = f"the value is dropped{lost}{why}; write `{each.intended}`"
            message = f"no node has a parameter `{each.name}`: {what}"
            yield each.path, Fault(each.span, message, "info" if is_mild else "warning")
