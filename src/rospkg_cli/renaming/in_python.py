"""Where Python names a package: in imports and what they bind, and in texts that stand for a package."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cached_property

from ..languages.python.file import PythonFile
from ..languages.python.nodes import nodes_of
from ..languages.python.syntax import parse
from ..light_dataclasses import dataclass
from ..source import Source, Span
from ..unreadable import UnreadableError
from .patterns import found
from .python_contexts import executables, named_texts
from .python_literal import literal_span
from .renamed_package import RenamedPackage

IMPORT = r"^[ \t]*(?:from|import)[ \t]+%PART%(?=[.\s])"


def in_python(source: Source, renamed: RenamedPackage, is_setup: bool) -> Iterator[Span]:
    """Yield the places; of a file that Python can't parse, the imports. `is_setup`: it is the package's setup.py."""
    try:
        file = PythonFile(source, parse(source))
    except UnreadableError:
        yield from found((IMPORT,) if renamed.has_module else (), source.text, renamed.old)
        return
    places = PythonPlaces(file, renamed)
    if renamed.has_module:
        yield from places.imports()
        yield from places.bound_names()
        yield from places.dotted_texts()
    for node in named_texts(file.tree, renamed.old, is_setup):
        if span := places.inner(node):
            yield span
    names = {f"{before}{renamed.old}{behind}": len(before) for before, behind in renamed.executables}
    for node in executables(file.tree, renamed.old, names):
        if span := places.inner(node, names[str(node.value)]):
            yield span


@dataclass(frozen=True)
class PythonPlaces:
    file: PythonFile
    renamed: RenamedPackage

    def imports(self) -> Iterator[Span]:
        for each in self.file.imports:
            if not each.level and each.module.partition(".")[0] == self.renamed.old:
                yield Span(each.span.start, each.span.start + len(self.renamed.old))

    def bound_names(self) -> Iterator[Span]:
        """Yield each use of the name that `import OLD` and `import OLD.x` bind."""
        if self.is_bound:
            for node in nodes_of(self.file.tree):
                if isinstance(node, ast.Name) and node.id == self.renamed.old:
                    yield self.file.span(node)

    @cached_property
    def is_bound(self) -> bool:
        aliases = [each for node in nodes_of(self.file.tree) if isinstance(node, ast.Import) for each in node.names]
        return any(each.asname is None and each.name.partition(".")[0] == self.renamed.old for each in aliases)

    def dotted_texts(self) -> Iterator[Span]:
        """Yield the name at the start of texts that name something in the module: `"OLD.node"`."""
        for node in nodes_of(self.file.tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                match = re.match(rf"{re.escape(self.renamed.old)}\.(\w+|\*)", node.value)
                if match and (match[1] == "*" or match[1] in self.renamed.submodules) and (span := self.inner(node)):
                    yield span

    def inner(self, node: ast.Constant, skipped: int = 0) -> Span | None:
        """Return the name behind some characters of a text; None where it is not written as one plain literal."""
        span = literal_span(self.file, node)
        return Span(span.start + skipped, span.start + skipped + len(self.renamed.old)) if span else None
