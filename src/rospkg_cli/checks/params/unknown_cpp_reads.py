"""Parameters that C++ code gets and nothing declares (PRM007)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...languages.cpp.call import CppCall
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import replace
from ...package.params.cpp_parameters import has_computed_cpp_names, read_in
from ...package.params.declared_parameter import DeclaredParameter
from ...suggest import near_names, nearest, slips
from .declaring_packages import is_its_own
from .parameter_reads import ParameterReads, allows_any
from .unknown_read import ASKED, BASE, MILD, UnknownRead, is_asked_for
from .unread_variables import is_dropped_in_cpp

MAKES_NODE = regex(r"[:,]\s*(?:rclcpp(?:_lifecycle)?::)?(?:Lifecycle)?Node\s*\(|Node::make_shared|<rclcpp::Node>\s*\(")
OTHERS = regex(r"PLUGINLIB_EXPORT_CLASS|ParametersClient|undeclare_parameter")
"""Code of a plugin, whose node others create, or of a client, which gets parameters of other nodes."""
ENOUGH_READS = 3
Read = tuple[DeclaredParameter, CppCall]


def unknown_cpp_reads(reads: ParameterReads) -> Iterator[UnknownRead]:
    """Yield what a C++ file gets and nothing declares, where it declares a similar name that it does not get.

    The names need not be similar where only one is got and not declared, and one declared and not got.
    """
    got = [read for file in reads.cpp for read, _ in read_in(file)]
    for file in reads.cpp if got and not any(allows_any(each.source) for each in reads.cpp) else ():
        unread = reads.unread(file.path, got)
        found = list(read_in(file))
        unread_here = reads.unread(file.path, [read for read, _ in found])
        unmatched = [pair for pair in found if is_unmatched(reads, file, *pair)]
        slipped = any(slips(read.name, unread_here) for read, _ in unmatched)
        if not unread and not slipped and is_stray(reads, file, unmatched, found):
            read, call = unmatched[0]
            place = (call.arguments or ())[0].span
            dropped = is_dropped_in_cpp(call, reads.cpp)
            found_here = UnknownRead(file.path, place, read.name, "", False, has_others=True, is_dropped=dropped)
            yield with_circumstances(reads, found_here, file, call)
        for read, call in unmatched if unread_here else ():
            only = len(unread) == 1 and len({read.name for read, _ in unmatched}) == 1
            suggestion = next(iter(unread)) if only else nearest(read.name, unread)
            suggestion = suggestion or next(iter(slips(read.name, unread_here)), None)
            if read.name.startswith(".") and suggestion not in near_names(read.name, unread_here):
                continue  # of a plugin, whose base class may declare it: only a misspelling is certain
            if suggestion is not None and call.arguments:
                throws = len(call.arguments) == 1 and not MILD.search(file.source.text)
                dropped, place = is_dropped_in_cpp(call, reads.cpp), call.arguments[0].span
                found_one = UnknownRead(file.path, place, read.name, suggestion, throws, is_dropped=dropped)
                yield with_circumstances(reads, found_one, file, call)


def is_unmatched(reads: ParameterReads, file: CppFile, read: DeclaredParameter, call: CppCall) -> bool:
    """Return whether nothing declares what a node gets of its own."""
    is_own = is_its_own(read.name) and not reads.is_declared(read, file.path)
    return is_own and not reads.own.is_of_others(file, call)


def with_circumstances(reads: ParameterReads, read: UnknownRead, file: CppFile, call: CppCall) -> UnknownRead:
    """Return a read with what else may declare the parameter, and whether the variable has an alternative."""
    has_other = call.name == "get_parameter_or" or len(call.arguments or ()) > 2
    unless = BASE if reads.own.may_inherit(file, call) else ASKED if is_asked_for(file.source, read.name) else ""
    return replace(read, unless=unless, has_other=has_other)


def is_stray(reads: ParameterReads, file: CppFile, unmatched: Sequence[Read], found: Sequence[Read]) -> bool:
    """Return whether the one name that is got and not declared has been forgotten.

    The file makes its node, declares the names of all other variables that it sets, and none is computed.
    """
    names = {read.name for read, _ in found}
    is_one = len({read.name for read, _ in unmatched}) == 1 and len(names) > ENOUGH_READS
    sets = all(len(call.arguments or ()) == 2 and not read.tail for read, call in unmatched)
    if not (is_one and sets and MAKES_NODE.search(file.source.text)) or OTHERS.search(file.source.text):
        return False
    own = {each.name for each in reads.package.parameters if each.path == file.path}
    is_open = any(has_computed_cpp_names(each) for each in reads.cpp)
    return len(names & own) == len(names) - 1 and not is_open
