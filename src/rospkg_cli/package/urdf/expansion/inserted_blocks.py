"""Insert a block that a macro was given, or a property of elements. (xacro/__init__.py: handle_insert_block)"""

from __future__ import annotations

from ....languages.xml.parser import Element
from ....light_dataclasses import replace
from .expansion import Node, XacroProblem
from .expansion_state import Context, ExpansionState
from .values import Stored, XacroBlock, XacroScope


def insert_block(state: ExpansionState, element: Element, into: list[Node], context: Context) -> None:
    """Expand the elements of a block in the scope that it comes from; report a block that is not there."""
    name = element.attributes.get("name")
    if name is None or "$" in name.value:
        state.found.is_open = True
        return
    homes = [(context.scope.home(f"{stars}{name.value}"), f"{stars}{name.value}") for stars in ("**", "*")]
    stored: Stored | None = next((home.names[key] for home, key in homes if home is not None), None)
    if isinstance(stored, XacroBlock):
        block = replace(context, source=stored.source, scope=stored.scope)
        if stored.content_only:
            state.inside(stored.element, into, block)
        else:
            state.element(stored.element, into, replace(block, depth=block.depth + 1))
    elif stored is None:
        known = {each.lstrip("*") for each in blocks_in(context.scope)}
        state.problem(XacroProblem.BLOCK, name.value_span, name.value, known)
    else:
        state.found.is_open = True


def blocks_in(scope: XacroScope | None) -> set[str]:
    """Return the names of the blocks in a scope and those around it, with their stars."""
    found: set[str] = set()
    while scope is not None:
        found |= {name for name in scope.names if name.startswith("*")}
        scope = scope.parent
    return found
