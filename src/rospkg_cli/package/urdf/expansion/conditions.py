"""Conditions and arguments of xacro, and which of them have an effect. (xacro/__init__.py: eval_all)"""

from __future__ import annotations

from ....languages.xml.parser import Element
from ....light_dataclasses import replace
from .expansion import Node, XacroProblem
from .expansion_state import Context, ExpansionState
from .values import XacroUnknown, shown, truth


def declare_argument(state: ExpansionState, element: Element, _: list[Node], context: Context) -> None:
    """Declare an argument; its default has an effect where no earlier element declares the same one."""
    default, name = element.attributes.get("default"), element.get("name") or ""
    value = state.evaluate(default.value_span, context) if default is not None else None
    note_way(state, element, context, goes_in=name not in state.texts.arguments)
    if state.with_defaults and value is not None:
        state.texts.defaults.setdefault(name, value)
    state.texts.arguments.add(name)


def expand_condition(state: ExpansionState, element: Element, into: list[Node], context: Context) -> None:
    """Expand the children of a condition that holds, or may hold; report a value that is no boolean."""
    written = element.attributes.get("value")
    value = state.evaluate(written.value_span, context) if written else XacroUnknown("")
    holds = truth(value)
    if holds is None and written is not None and not isinstance(value, XacroUnknown):
        state.problem(XacroProblem.CONDITION, written.value_span, shown(value), ())
    note_way(state, element, context, goes_in=holds in (None, element.tag == "xacro:if"))
    if holds is None:
        state.inside(element, into, replace(context, is_certain=False))
    elif holds is (element.tag == "xacro:if"):
        state.inside(element, into, context)


def note_way(state: ExpansionState, element: Element, context: Context, *, goes_in: bool) -> None:
    """Keep whether xacro ever enters a condition, or uses the default of an argument, of those that it reaches."""
    place = (context.source.path, element.span)
    state.found.ways[place] = goes_in or state.found.ways.get(place, False)
