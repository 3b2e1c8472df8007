"""The packages of the generated types, such as `nav_msgs::msg::Odometry`, that C++ code names."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator

from ...languages.cpp.file import CppFile
from ...languages.cpp.lexer import TOKEN
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ...source import Source, Span
from .compiled_sources import compiled_sources
from .included_packages import IncludedPackage, IncludeUse

PACKAGE, QUALIFIER = regex(r"[a-z][a-z0-9_]*"), regex(r"[\w:]")
OF_CLIENT_LIBRARIES = frozenset(
    "action_msgs builtin_interfaces composition_interfaces lifecycle_msgs rcl_interfaces rosgraph_msgs service_msgs "
    "statistics_msgs type_description_interfaces unique_identifier_msgs".split()
)
"""Packages of interfaces that come with rclcpp, whose own functions take and return their types."""


def packages_of_types(cmake: CMake, sources: Iterable[CppFile], workspace: Workspace) -> Iterator[IncludedPackage]:
    """Yield the packages whose types are named, each by the first, those of tests after those of what is built."""
    found: dict[str, IncludedPackage] = {}
    for source, role in sorted(compiled_sources(cmake, sources), key=lambda each: each[1] == "test"):
        for package, span in named_types(source.source) if role != "aside" else ():
            if package in found or package in OF_CLIENT_LIBRARIES:
                continue
            known = workspace.kind_of(package) is NameKind.PACKAGE
            if known and is_code(source.source, span.start):
                use = IncludeUse(source.path, span, source.source.slice(span), is_type=True)
                found[package] = IncludedPackage((package,), package, role, (use,))
    yield from found.values()


def named_types(source: Source) -> Iterator[tuple[str, Span]]:
    """Yield the generated types that a C++ text names, each with its package; those in comments and strings, too."""
    from ...package.interfaces.generated_types import generated_types  # a package without C++ needs none

    for each in generated_types(source):
        before = source.text[max(0, each.start - 3) : each.start]
        is_whole = before[-1:] != ":" or (before[-2:] == "::" and not QUALIFIER.match(before[:-2]))
        if is_whole and PACKAGE.fullmatch(each.package):
            yield each.package, Span(each.start, each.end)


def is_code(source: Source, offset: int) -> bool:
    """Return whether an offset of a C++ text is outside of comments and strings."""
    known = vars(source)
    if "hidden_spans" not in known:
        known["hidden_spans"] = [match.span() for match in TOKEN.finditer(source.text)]
    hidden: list[tuple[int, int]] = known["hidden_spans"]
    at = bisect_right(hidden, (offset, len(source.text)))
    return at == 0 or offset >= hidden[at - 1][1]
