"""Include a file in the expansion of a robot. (xacro/__init__.py: process_include)"""

from __future__ import annotations

from ....languages.xml.parser import Element
from ....lazy_regex import regex
from ....light_dataclasses import replace
from .expansion import Node
from .expansion_state import Context, ExpansionState
from .values import XacroUnknown

COMPUTED = regex(r"[})](?:@\d+)?")
"""The end of a computed part of a file name, with the mark of its scope."""


def include_file(state: ExpansionState, element: Element, into: list[Node], context: Context) -> None:
    """Expand the elements of an included file; the robot stays open where the file is not known or not there."""
    filename = element.attributes.get("filename")
    name = state.evaluate(filename.value_span, context) if filename else XacroUnknown("")
    document = None
    if isinstance(name, str) and element.get("ns") is None:
        document = state.library.included(name, context.source.path)
    if document is None:
        state.found.is_open = state.found.lacks_files = True
        if isinstance(name, XacroUnknown):
            redefine(state, name, context)
        return
    state.found.reached.add(document.source.path)
    if context.is_certain:
        state.found.certain.add(document.source.path)
    state.inside(document.root, into, replace(context, source=document.source))


def redefine(state: ExpansionState, name: XacroUnknown, context: Context) -> None:
    """Mark the macros that a file of a computed name may redefine: their parameters are not known."""
    tail = COMPUTED.split(name.text)[-1]
    for each in context.scope.visible_macros():
        macro = context.scope.macro(each)
        if macro is not None and state.library.defining(each, tail) - {macro.source.path}:
            context.scope.macros[each] = replace(macro, is_certain=False)
