"""Expand a robot as xacro does: in the order of the text, macros where they are called. (xacro: eval_all)"""

from __future__ import annotations

from collections.abc import Iterator

from ....languages.xml.parser import Document, Element
from ....light_dataclasses import dataclass, field, replace
from ....source import Span
from ..references import text_spans
from .conditions import declare_argument, expand_condition
from .expansion import ExpandedAttribute, Expansion, Node, XacroProblem
from .expansion_state import Context, ExpansionState
from .included_files import include_file
from .inserted_blocks import insert_block
from .macro_calls import bound_scope
from .macros import Macro, macro_name, parameters_of
from .properties import keep_property
from .values import XacroScope, XacroUnknown

MAX_NODES = 30_000
MAX_DEPTH = 60
DYNAMIC = frozenset({"xacro:element", "xacro:attribute", "xacro:call"})


@dataclass
class Expander(ExpansionState):
    called: set[int] = field(default_factory=set)
    """The macros that were expanded, by the `id` of their elements."""
    defined: list[Macro] = field(default_factory=list)
    nodes: int = 0

    def run(self, document: Document) -> Expansion:
        self.found.reached.add(document.source.path)
        self.found.certain.add(document.source.path)
        self.inside(document.root, self.found.children, Context(document.source, self.scope))
        return self.found

    def uncalled(self) -> Iterator[tuple[Macro, Expansion]]:
        """Yield the macros of the robot that nothing called, each with its expansion for unknown parameters.

        Of several macros of one name, each under a condition, only the last one counts as called.
        """
        for macro in list(self.defined):
            if id(macro.element) not in self.called:
                scope = XacroScope(self.scope)
                for each in macro.parameters:
                    scope.names[each.name] = XacroUnknown(f"${{{each.name}}}")
                made = replace(self.found, children=[], problems=[])
                self.inside(macro.element, made.children, Context(macro.source, scope, macro.is_certain))
                yield macro, made

    def inside(self, element: Element, into: list[Node], context: Context) -> None:
        """Expand the children of an element."""
        self.nodes += 1
        if context.depth > MAX_DEPTH or self.nodes > MAX_NODES:
            self.found.is_open = self.found.lacks_files = True
            return
        deeper = replace(context, depth=context.depth + 1)
        for span in text_spans(element) if element.chunks and not element.is_self_closing else ():
            if "$" in context.source.text[span.start : span.end]:
                self.evaluate(span, deeper)
        for child in element.children:
            self.element(child, into, deeper)

    def element(self, element: Element, into: list[Node], context: Context) -> None:
        self.at = context
        if not element.tag.startswith("xacro:"):
            into.append(self.plain(element, context))
        elif handler := HANDLERS.get(element.tag):
            handler(self, element, into, context)
        elif element.tag in DYNAMIC or "." in element.tag:
            self.unknown_call(element, context)
        else:
            self.call(element, into, context)

    def plain(self, element: Element, context: Context) -> Node:
        node = Node(element.tag, element, context.source, context.is_certain, context.calls)
        for name, attribute in element.attributes.items():
            if not name.startswith("xacro:"):
                node.attributes[name] = ExpandedAttribute(
                    self.evaluate(attribute.value_span, context), attribute.value_span
                )
        self.inside(element, node.children, context)
        return node

    def property(self, element: Element, _: list[Node], context: Context) -> None:
        keep_property(self, element, context)

    def macro(self, element: Element, _: list[Node], context: Context) -> None:
        name = macro_name(element)
        certain = context.is_certain and (name not in context.scope.macros or context.scope.macros[name].is_certain)
        parameters = parameters_of(element.get("params") or "")
        made = context.scope.macros[name] = Macro(name, parameters, element, context.source, certain)
        if context.scope is self.scope:
            self.defined.append(made)

    def unknown_call(self, element: Element, context: Context) -> None:
        """Evaluate the attributes of a call whose macro is not known, as xacro does, and leave the robot open."""
        for attribute in element.attributes.values():
            self.evaluate(attribute.value_span, context)
        self.found.is_open = True

    def call(self, element: Element, into: list[Node], context: Context) -> None:
        name = element.tag.removeprefix("xacro:")
        macro = context.scope.macro(name)
        if macro is None:
            start = element.span.start + 1
            self.problem(
                XacroProblem.MACRO, Span(start, start + len(element.tag)), name, context.scope.visible_macros()
            )
            self.unknown_call(element, context)
            return
        self.called.add(id(macro.element))
        scope = bound_scope(self, element, macro, context)
        if scope is None:
            self.found.is_open = True
            return
        certain, site = context.is_certain and macro.is_certain, (context.source, element)
        body = Context(macro.source, scope, certain, (*context.calls, site), context.depth)
        self.inside(macro.element, into, body)


HANDLERS = {
    "xacro:include": include_file,
    "xacro:property": Expander.property,
    "xacro:macro": Expander.macro,
    "xacro:arg": declare_argument,
    "xacro:if": expand_condition,
    "xacro:unless": expand_condition,
    "xacro:insert_block": insert_block,
}
