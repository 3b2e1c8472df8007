"""Parameters that Python code gets and nothing declares (PRM007)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import replace
from ...package.params.python_parameters import has_computed_names
from ...package.params.python_parameters import read_in as read_in_python
from ...suggest import nearest, slips
from .declaring_packages import is_its_own
from .on_request import parts_on_request
from .parameter_reads import ParameterReads, allows_any
from .unknown_read import ASKED, BASE, MILD, UnknownRead, is_asked_for
from .unread_variables import is_dropped_in_python


def unknown_python_reads(reads: ParameterReads) -> Iterator[UnknownRead]:
    """Yield what a Python file gets and nothing declares, where it declares one similar name by a literal."""
    paths = sorted({each.path for each in reads.package.parameters if each.path.endswith(".py")})
    files = [file for path in paths if (file := reads.modules.at(path))]
    got = [read for file in files for read, _, _ in read_in_python(file)]
    nodes = (*files, *reads.run_files)  # one of these may create the node whose parameters another gets
    if any(map(has_computed_names, files)) or any(allows_any(file.source) for file in nodes):
        return
    for file in files:
        found = list(read_in_python(file))
        unread = reads.unread(file.source.path, got)
        unread_here = reads.unread(file.source.path, [read for read, _, _ in found])
        for read, span, throws in found if unread_here else ():
            is_of_others = reads.own_python.is_of_others(file, span.start)
            if is_its_own(read.name) and not reads.is_declared(read) and not is_of_others:
                suggestion = nearest(read.name, unread) or next(iter(slips(read.name, unread_here)), None)
                if suggestion is not None:
                    on_request = any(each.holds(span) for each in parts_on_request(file))
                    throws = throws and not MILD.search(file.source.text)
                    dropped = not throws and is_dropped_in_python(file, span, reads.every_python)
                    found_here = UnknownRead(file.source.path, span, read.name, suggestion, throws, True)
                    unless = BASE if reads.own_python.may_inherit(file, span.start) else ""
                    unless = ASKED if is_asked_for(file.source, read.name) else unless
                    yield replace(found_here, on_request=on_request, is_dropped=dropped, unless=unless)
