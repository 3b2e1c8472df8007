"""Give a macro its parameters and blocks. (xacro/__init__.py: handle_macro_call)"""

from __future__ import annotations

from ....languages.xml.parser import Element
from ....light_dataclasses import replace
from ....source import Span
from .expansion import XacroProblem
from .expansion_state import Context, ExpansionState
from .macros import Macro, MacroParameter
from .values import Stored, Value, XacroBlock, XacroPlace, XacroScope, XacroUnknown, literal


def bound_scope(state: ExpansionState, call: Element, macro: Macro, context: Context) -> XacroScope | None:
    """Return the names of a macro's body; None where xacro refuses the call, which is reported."""
    scope = XacroScope(context.scope)
    faultless = given_parameters(state, call, macro, scope, context)
    faultless = faultless and given_blocks(state, call, macro, scope, context)
    missing = [each for each in macro.parameters if not each.is_block and each.name not in scope.names]
    for parameter in missing if faultless else ():
        scope.names[parameter.name] = default_of(state, parameter, macro, context)
    absent = [each.name for each in missing if each.is_required]
    if absent and faultless:
        state.at = context
        start = call.span.start + 1
        span = Span(start, start + len(call.tag))
        if macro.is_certain:
            state.problem(XacroProblem.MISSING, span, "`, `".join(absent), (), macro.name)
        faultless = False
    return scope if faultless else None


def given_parameters(state: ExpansionState, call: Element, macro: Macro, scope: XacroScope, context: Context) -> bool:
    names, faultless = {each.name for each in macro.parameters}, True
    for name, attribute in call.attributes.items():
        if name.startswith("xmlns"):
            continue
        if name not in names:
            state.at = context
            start = attribute.span.start
            if macro.is_certain:
                state.problem(XacroProblem.PARAMETER, Span(start, start + len(name)), name, names, macro.name)
            faultless = False
            continue
        found = state.evaluate(attribute.value_span, context)
        scope.names[name] = literal(found) if isinstance(found, str) else found
    return faultless


def given_blocks(state: ExpansionState, call: Element, macro: Macro, scope: XacroScope, context: Context) -> bool:
    """Bind the blocks in their order; where xacro makes the blocks, all that is known is that there are some."""
    wanted = [each.name for each in macro.parameters if each.is_block]
    blocks: list[Stored] = []
    for child in call.children:
        if child.tag.startswith("xacro:") and child.tag != "xacro:insert_block":
            scope.names.update(dict.fromkeys(wanted, XacroUnknown("")))
            return True
        blocks.append(block_of(child, context))
    state.at = context
    start = call.span.start + 1
    span = Span(start, start + len(call.tag))
    if len(blocks) != len(wanted) and macro.is_certain and not any(isinstance(each, XacroUnknown) for each in blocks):
        few = len(blocks) < len(wanted)
        kind = XacroProblem.FEW_BLOCKS if few else XacroProblem.MANY_BLOCKS
        name = wanted[len(blocks)] if few else call.children[len(wanted)].tag
        state.problem(kind, span, name.lstrip("*"), (), macro.name)
        return False
    blocks += [XacroUnknown("")] * (len(wanted) - len(blocks))
    for name, block in zip(wanted, blocks, strict=False):
        content_only = name.startswith("**")
        scope.names[name] = replace(block, content_only=content_only) if isinstance(block, XacroBlock) else block
    return True


def block_of(child: Element, context: Context) -> Stored:
    """Return an element as a block; one that inserts another block is that block, where it is one element."""
    if child.tag != "xacro:insert_block":
        return XacroBlock(child, context.scope, context.source, False)
    home = context.scope.home(f"*{child.get('name')}")
    stored = home.names[f"*{child.get('name')}"] if home is not None else XacroUnknown("")
    return stored if isinstance(stored, XacroBlock) else XacroUnknown("")


def default_of(state: ExpansionState, parameter: MacroParameter, macro: Macro, context: Context) -> Value:
    """Return the default of a parameter: the caller's property of that name, or the text behind `:=`."""
    home = context.scope.home(parameter.name) if parameter.is_forwarded else None
    if home is not None:
        return state.texts.read(parameter.name, home)
    if parameter.default is None:
        return XacroUnknown(f"${{{parameter.name}}}")
    params = macro.element.attributes["params"]
    raw = macro.source.slice(params.value_span)
    at = raw.find(parameter.default, raw.find(parameter.name))
    if at < 0:
        return XacroUnknown(parameter.default)
    start = params.value_span.start + at
    state.at = replace(context, source=macro.source)
    span = Span(start, start + len(parameter.default))
    found = state.texts.evaluate(XacroPlace(macro.source, span), context.scope)
    return literal(found) if isinstance(found, str) else found
