"""What has colcon test a package of type ament_python with pytest."""

from __future__ import annotations

from collections.abc import Iterator

from ..edits.list_item import append_item, removals
from ..edits.setup_py import own_arguments, quoted
from ..light_dataclasses import dataclass
from ..package.package import Package
from ..source import Span
from .entry_point import setup_of
from .part import Operations


@dataclass(frozen=True)
class TestExtras:
    """`extras_require={'test': ['pytest']}` in the call of setup()."""

    __test__ = False  # pytest would take it for tests of its own

    def add(self, package: Package) -> Operations:
        """Return the argument, nothing where setup.py says so already, or may."""
        setup = setup_of(package)
        if setup.call is None or setup.call.rest is not None or setup.has_test_extras or setup.cfg_broken:
            return ()
        if setup.argument("extras_require") is not None or setup.argument("tests_require") is not None:
            return ()
        start = setup.source.text.index("(", setup.call.span.start)
        spans = [argument.span for argument in own_arguments(setup)]
        code = f"extras_require={{{quoted(setup, 'test')}: [{quoted(setup, 'pytest')}]}}"
        return append_item(setup.source, Span(start, setup.call.span.end), spans, code)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of an argument that says nothing else, where no other test is left."""
        setup = setup_of(package)
        tests = [path for path in package.files.paths if path.rpartition("/")[2].startswith("test_")]
        if len(tests) > 1:
            return
        for argument in own_arguments(setup):
            code = setup.source.slice(argument.span).replace('"', "'").replace(" ", "")
            if code == "extras_require={'test':['pytest']}":
                yield from removals(setup.source, argument.span)
