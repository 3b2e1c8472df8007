"""Look-ups of packages in Python code with arguments that they do not take (DEP112)."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ..languages.python.file import PythonFile
from ..languages.python.guarded_nodes import guarded_nodes
from ..languages.python.nodes import nodes_of_kind
from ..languages.python.unreached_places import is_unreached
from ..light_dataclasses import dataclass
from ..ros.python_calls import INDEX
from ..source import Span
from .python.wrong_calls import CATCHES, wrong_lookup
from .share_lookups import ShareLookups


@dataclass(frozen=True, slots=True)
class WrongLookup:
    path: str
    span: Span
    name: str
    why: str


def wrong_lookups(lookups: ShareLookups) -> Iterator[WrongLookup]:
    for file in lookups.modules:
        names = names_of_index(file)
        caught = frozenset(guarded_nodes(file.tree.body, CATCHES)) if names else frozenset()
        for call in nodes_of_kind(file.tree, ast.Call) if names else ():
            match call.func:
                case ast.Name(id=name) if name in names and id(call) not in caught:
                    why, span = wrong_lookup(call), file.span(call.func)
                    if why and not is_unreached(file, span):
                        yield WrongLookup(file.path, span, name, why)


def names_of_index(file: PythonFile) -> set[str]:
    """Return the functions that a file imports of ament_index_python, and does not define itself."""
    found = (each for each in file.imports if each.module.partition(".")[0] == INDEX)
    return {name for each in found for name in each.names} - {*file.functions}
