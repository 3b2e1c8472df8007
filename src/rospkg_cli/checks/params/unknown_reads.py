"""Parameters that code gets and nothing declares, where the same file declares a similar one that no code gets."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from functools import cached_property

from ...languages.cpp.call import CppCall
from ...languages.cpp.file import CppFile
from ...languages.python.file import PythonFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.package_facts import PackageFacts
from ...package.params.cpp_parameters import has_computed_cpp_names, read_in
from ...package.params.declared_parameter import DeclaredParameter
from ...package.params.python_parameters import has_computed_names
from ...package.params.python_parameters import read_in as read_in_python
from ...package.python.python_imports import PackageImports
from ...package.python_modules import PythonModules
from ...package.workspace import Workspace
from ...source import Source, Span
from ...suggest import near_names, nearest, slips
from .declaring_packages import is_its_own
from .on_request import parts_on_request
from .own_python_reads import OwnPythonReads
from .own_reads import OwnReads
from .unread_variables import is_dropped_in_cpp, is_dropped_in_python

ALLOWED = ("allow_undeclared_parameters", "automatically_declare_parameters_from_overrides")
"""Options of a node that has parameters which no code declares."""
MAKES_NODE = regex(r"[:,]\s*(?:rclcpp(?:_lifecycle)?::)?(?:Lifecycle)?Node\s*\(|Node::make_shared|<rclcpp::Node>\s*\(")
OTHERS = regex(r"PLUGINLIB_EXPORT_CLASS|ParametersClient|undeclare_parameter")
"""Code of a plugin, whose node others make, or of a client, which asks other nodes."""
MAIN = regex(r"\bint\s+main\s*\(")
ENOUGH_READS = 3
BASE, ASKED = "; unless its base class does", "; unless others do, for which it asks first"
Read = tuple[DeclaredParameter, CppCall]
MILD = regex(r"\bcatch\b|\bhas_parameter\b|\bexcept\s*(?::|.*\b(?:Base)?Exception\b|.*\bParameter)")
"""What may catch the exception, or ask before."""


@dataclass(frozen=True, slots=True)
class UnknownRead:
    path: str
    span: Span
    name: str
    suggestion: str
    """"" where the file gets all else that it declares."""
    throws: bool
    """Whether it certainly throws: it gets one parameter by its name, and nothing in the file may catch that."""
    is_python: bool = False
    has_others: bool = False
    """Whether the file declares all others that it gets."""
    on_request: bool = False
    """Whether only a request to a service or an action comes to it."""
    is_dropped: bool = False
    """Whether nothing reads the variable that it is got into."""
    unless: str = ""
    """What else may declare it: a base class that is not here, or whoever is asked first whether it is there."""
    has_other: bool = False
    """Whether the variable is set to an alternative."""
    more: tuple[tuple[str, Span], ...] = ()
    """Other names of the file of which the same is true, and where they stand."""


@dataclass(frozen=True)
class ParameterReads:
    """What the code of a package gets, and what its code and that of its neighbours declares."""

    cpp: tuple[CppFile, ...]
    modules: PythonModules
    package: PackageFacts
    workspace: Workspace
    python: PackageImports

    def in_cpp(self) -> Iterator[UnknownRead]:
        """Yield what a C++ file gets and nothing declares; its name is similar, or there is only one of each.

        Where other code gets all that the file declares, it is a slip of what this file declares and does not get.
        """
        reads = [read for file in self.cpp for read, _ in read_in(file)]
        for file in self.cpp if reads and not any(allows_any(each.source) for each in self.cpp) else ():
            unread = self.unread(file.path, reads)
            found = list(read_in(file))
            unread_here = self.unread(file.path, [read for read, _ in found])
            unmatched = [pair for pair in found if self.is_unmatched(file, *pair)]
            slipped = any(slips(read.name, unread_here) for read, _ in unmatched)
            if not unread and not slipped and self.is_stray(file, unmatched, found):
                read, call = unmatched[0]
                place = (call.arguments or ())[0].span
                dropped = is_dropped_in_cpp(call, self.cpp)
                found_here = UnknownRead(file.path, place, read.name, "", False, has_others=True, is_dropped=dropped)
                yield self.told_more(found_here, file, call)
            for read, call in unmatched if unread_here else ():
                only = len(unread) == 1 and len({read.name for read, _ in unmatched}) == 1
                suggestion = next(iter(unread)) if only else nearest(read.name, unread)
                suggestion = suggestion or next(iter(slips(read.name, unread_here)), None)
                if read.name.startswith(".") and suggestion not in near_names(read.name, unread_here):
                    continue  # a plugin's, whose base class may declare it: a slip alone is certain
                if suggestion is not None and call.arguments:
                    throws = len(call.arguments) == 1 and not MILD.search(file.source.text)
                    dropped, place = is_dropped_in_cpp(call, self.cpp), call.arguments[0].span
                    found_one = UnknownRead(file.path, place, read.name, suggestion, throws, is_dropped=dropped)
                    yield self.told_more(found_one, file, call)

    def is_unmatched(self, file: CppFile, read: DeclaredParameter, call: CppCall) -> bool:
        """Return whether nothing declares what a node gets of its own."""
        is_own = is_its_own(read.name) and not self.is_declared(read, file.path)
        return is_own and not self.own.is_of_others(file, call)

    def told_more(self, read: UnknownRead, file: CppFile, call: CppCall) -> UnknownRead:
        has_other = call.name == "get_parameter_or" or len(call.arguments or ()) > 2
        unless = BASE if self.own.may_inherit(file, call) else ASKED if is_asked_for(file.source, read.name) else ""
        return replace(read, unless=unless, has_other=has_other)

    @cached_property
    def own(self) -> OwnReads:
        return OwnReads(self.cpp)

    @cached_property
    def own_python(self) -> OwnPythonReads:
        return OwnPythonReads(tuple(self.run_files))

    def is_stray(self, file: CppFile, unmatched: Sequence[Read], found: Sequence[Read]) -> bool:
        """Return whether the one name that is got and not declared has been forgotten.

        The file makes its node, declares the names of all other variables that it sets, and none is computed.
        """
        names = {read.name for read, _ in found}
        is_one = len({read.name for read, _ in unmatched}) == 1 and len(names) > ENOUGH_READS
        sets = all(len(call.arguments or ()) == 2 and not read.tail for read, call in unmatched)
        if not (is_one and sets and MAKES_NODE.search(file.source.text)) or OTHERS.search(file.source.text):
            return False
        own = {each.name for each in self.package.parameters if each.path == file.path}
        is_open = any(has_computed_cpp_names(each) for each in self.cpp)
        return len(names & own) == len(names) - 1 and not is_open

    def in_python(self) -> Iterator[UnknownRead]:
        """Yield what a Python file gets and nothing declares, where it declares one similar name by a literal."""
        paths = sorted({each.path for each in self.package.parameters if each.path.endswith(".py")})
        files = [file for path in paths if (file := self.modules.at(path))]
        reads = [read for file in files for read, _, _ in read_in_python(file)]
        nodes = (*files, *self.run_files)  # one of these may make the node that another gets parameters of
        if any(map(has_computed_names, files)) or any(allows_any(file.source) for file in nodes):
            return
        for file in files:
            found = list(read_in_python(file))
            unread = self.unread(file.source.path, reads)
            unread_here = self.unread(file.source.path, [read for read, _, _ in found])
            for read, span, throws in found if unread_here else ():
                is_of_others = self.own_python.is_of_others(file, span.start)
                if is_its_own(read.name) and not self.is_declared(read) and not is_of_others:
                    suggestion = nearest(read.name, unread) or next(iter(slips(read.name, unread_here)), None)
                    if suggestion is not None:
                        on_request = any(each.holds(span) for each in parts_on_request(file))
                        throws = throws and not MILD.search(file.source.text)
                        dropped = not throws and is_dropped_in_python(file, span, self.every_python)
                        found_here = UnknownRead(file.source.path, span, read.name, suggestion, throws, True)
                        unless = BASE if self.own_python.may_inherit(file, span.start) else ""
                        unless = ASKED if is_asked_for(file.source, read.name) else unless
                        yield replace(found_here, on_request=on_request, is_dropped=dropped, unless=unless)

    @property
    def run_files(self) -> Iterator[PythonFile]:
        """The modules and programs in Python."""
        paths = sorted(each.path for each in self.python.files if each.role == "run")
        return (file for path in paths if (file := self.modules.at(path)))

    def unread(self, path: str, reads: Collection[DeclaredParameter]) -> set[str]:
        """Return the names that a file declares and no code of the package gets."""
        own = [each for each in self.package.parameters if each.path == path]
        return {each.name for each in own if not any(same(each, read) for read in reads)}

    @cached_property
    def every_python(self) -> tuple[PythonFile, ...]:
        """All files of Python that can be parsed."""
        paths = (path for path in self.modules.files.paths if path.endswith(".py"))
        return tuple(file for path in paths if (file := self.modules.at(path)))

    @cached_property
    def programs(self) -> frozenset[str]:
        """The C++ files that have a `main`."""
        return frozenset(file.path for file in self.cpp if MAIN.search(file.source.text))

    def is_declared(self, read: DeclaredParameter, path: str = "") -> bool:
        """Return whether any code may declare what is read in a file: no other program, where that is one itself."""
        others = self.programs - {path} if path in self.programs else frozenset[str]()
        here = [each for each in self.package.parameters if each.path not in others]
        if any(same(each, read) or (each.tail and read.name.endswith(each.name)) for each in here):
            return True
        packages = (facts for facts in self.workspace.packages if facts is not self.package)
        return any(same(each, read) for facts in packages for each in facts.parameters)


def allows_any(source: Source) -> bool:
    """Return whether a node of a file may have parameters that no code declares."""
    return any(word in source.text for word in ALLOWED)


def is_asked_for(source: Source, name: str) -> bool:
    """Return whether a file asks whether there is a parameter."""
    return re.search(rf"has_parameter\s*\(\s*['\"]{re.escape(name)}['\"]", source.text) is not None


def same(declared: DeclaredParameter, read: DeclaredParameter) -> bool:
    """Return whether a read may mean what is declared."""
    return declared.name == read.name or declared.fits(read.name) or read.fits(declared.name)
