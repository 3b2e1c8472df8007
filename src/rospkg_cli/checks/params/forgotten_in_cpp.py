"""Parameters that C++ code of a node gets, and that no code declares under any similar name (PRM007)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.params.cpp_parameters import has_computed_cpp_names, read_in
from .forgotten_in_python import counted, is_declared
from .parameter_events import CPP_TEXT
from .parameter_reads import ParameterReads, allows_any
from .unknown_cpp_reads import OTHERS
from .unknown_read import MILD, UnknownRead
from .unread_variables import is_dropped_in_cpp

HELPERS = regex(r"ParamListener|\b(?!declare_parameters?\b|DECLARES?\b)\w*[Dd]eclare\w*\s*[<(]|\w*DECLARE\w*\s*\(")
"""Code that may declare parameters whose names it does not hold."""
MAKES = regex(
    r"(?:[:,]\s*(?:rclcpp(?:_lifecycle)?::)?(?:Lifecycle)?Node|Node::make_shared|<rclcpp::Node>)"
    r"\s*\((?P<options>[^()]*[()])"
)
PLAIN = regex(r'\s*"[^"]*"\s*(?:,\s*"[^"]*"\s*)?\)')
"""A name, perhaps with a namespace, and nothing else."""
BUILDS = frozenset({"depend", "build_depend", "build_export_depend"})


@dataclass(frozen=True)
class ForgottenInCpp:
    """Reads in C++ of names that occur nowhere in the code of a package but where it gets them."""

    reads: ParameterReads

    def all(self) -> Iterator[UnknownRead]:
        """Yield the parameters that files which create their nodes get into variables or by name."""
        files = self.reads.cpp
        is_open = any(allows_any(each.source) or HELPERS.search(each.source.text) for each in files)
        if is_open or any(map(has_computed_cpp_names, files)) or self.reads.own.is_handed_out:
            return
        for file in files:
            if self.is_closed(file) and not OTHERS.search(file.source.text):
                yield from self.in_node(file)

    def is_closed(self, file: CppFile) -> bool:
        """Return whether a file makes nodes, and no other code may choose their options."""
        made = [found.group("options") for found in MAKES.finditer(file.source.text)]
        is_given = any(PLAIN.fullmatch(options) is None for options in made)
        return bool(made) and not (is_given and any(map(self.may_make, self.reads.workspace.packages)))

    def may_make(self, facts: PackageFacts) -> bool:
        """Return whether a package is built on this one, and has code of its own."""
        is_built = any(each.name == self.reads.package.name and each.tag in BUILDS for each in facts.dependencies)
        return is_built and bool(facts.executables or facts.components or not facts.knows("executables"))

    def in_node(self, file: CppFile) -> Iterator[UnknownRead]:
        seen: set[str] = set()
        for read, call in read_in(file):
            is_free = read.tail or call.name != "get_parameter" or read.name in seen
            is_free = is_free or self.reads.own.is_of_others(file, call) or self.reads.own.may_inherit(file, call)
            if not is_free and self.cpp_reads.get(read.name) == self.cpp_texts.get(read.name):
                seen.add(read.name)
                if not is_declared(self.reads, read):
                    first, *others = call.arguments or ()
                    throws = not others and not MILD.search(file.source.text)
                    dropped = is_dropped_in_cpp(call, self.reads.cpp)
                    yield UnknownRead(file.path, first.span, read.name, "", throws, is_dropped=dropped)

    @cached_property
    def cpp_reads(self) -> dict[str, int]:
        return counted(read.name for file in self.reads.cpp for read, _ in read_in(file))

    @cached_property
    def cpp_texts(self) -> dict[str, int]:
        """How often each text stands in the code."""
        return counted(found.group()[1:-1] for file in self.reads.cpp for found in CPP_TEXT.finditer(file.source.text))
