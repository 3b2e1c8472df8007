"""Properties of xacro: a text that is evaluated where it is first read, or elements. (xacro: grab_property)"""

from __future__ import annotations

from ....languages.xml.parser import Element
from .expansion_state import Context, ExpansionState
from .values import XacroBlock, XacroPlace, XacroText, XacroUnknown, literal


def keep_property(state: ExpansionState, element: Element, context: Context) -> None:
    """Put a property into its table; one whose name xacro makes leaves the robot open."""
    name, value, default = (element.attributes.get(each) for each in ("name", "value", "default"))
    if name is None or "$" in name.value:
        state.found.is_open = True
        return
    if element.get("remove") is not None:
        context.scope.names[name.value] = XacroUnknown(f"${{{name.value}}}")
    elif value is not None:
        store(state, name.value, XacroPlace(context.source, value.value_span), element, context)
    elif default is not None:
        if context.scope.home(name.value) is None:
            store(state, name.value, XacroPlace(context.source, default.value_span), element, context)
    else:
        context.scope.names[f"**{name.value}"] = XacroBlock(element, context.scope, context.source, True)


def store(state: ExpansionState, name: str, place: XacroPlace, element: Element, context: Context) -> None:
    where, text = element.get("scope"), place.source.slice(place.span)
    target = context.scope.top if where == "global" else context.scope
    target = (context.scope.parent or target) if where == "parent" else target
    if not context.is_certain:
        target.names[name] = XacroUnknown(f"${{{name}}}")
    elif "$" not in text:
        found = literal(text)  # what stands in quotes is read once more where it is evaluated
        target.names[name] = literal(found) if isinstance(found, str) else found
    elif where or element.get("lazy_eval") == "false":
        found = state.evaluate(place.span, context)
        target.names[name] = literal(found) if isinstance(found, str) else found
    else:
        target.names[name] = XacroText(place)
