"""Expand a robot as xacro does: in the order of the text, macros where they are called. (xacro: eval_all)"""

from __future__ import annotations

from collections.abc import Iterator

from ....languages.xml.parser import Document, Element
from ....lazy_regex import regex
from ....light_dataclasses import dataclass, field, replace
from ....source import Span
from ..references import text_spans
from .expansion import ExpandedAttribute, Expansion, Node, XacroProblem
from .expansion_state import Context, ExpansionState
from .macro_calls import bound_scope
from .macros import Macro, macro_name, parameters_of
from .properties import keep_property
from .values import Stored, XacroBlock, XacroScope, XacroUnknown, shown, truth

MAX_NODES = 30_000
MAX_DEPTH = 60
COMPUTED = regex(r"[})](?:@\d+)?")
"""The end of a part of a name that is computed, with the mark of its scope."""
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
        """Yield the macros of the robot that nothing called, and what each makes with parameters of unknown values.

        One of several of a name, each under a condition, is among them: the last one is called.
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

    def include(self, element: Element, into: list[Node], context: Context) -> None:
        filename = element.attributes.get("filename")
        name = self.evaluate(filename.value_span, context) if filename else XacroUnknown("")
        document = None
        if isinstance(name, str) and element.get("ns") is None:
            document = self.library.included(name, context.source.path)
        if document is None:
            self.found.is_open = self.found.lacks_files = True
            if isinstance(name, XacroUnknown):
                self.redefine(name, context)
            return
        self.found.reached.add(document.source.path)
        if context.is_certain:
            self.found.certain.add(document.source.path)
        self.inside(document.root, into, replace(context, source=document.source))

    def redefine(self, name: XacroUnknown, context: Context) -> None:
        """Mark the macros that a file of a computed name may define again: what they take is not known."""
        tail = COMPUTED.split(name.text)[-1]
        for each in context.scope.visible_macros():
            macro = context.scope.macro(each)
            if macro is not None and self.library.defining(each, tail) - {macro.source.path}:
                context.scope.macros[each] = replace(macro, is_certain=False)

    def property(self, element: Element, _: list[Node], context: Context) -> None:
        keep_property(self, element, context)

    def macro(self, element: Element, _: list[Node], context: Context) -> None:
        name = macro_name(element)
        certain = context.is_certain and (name not in context.scope.macros or context.scope.macros[name].is_certain)
        parameters = parameters_of(element.get("params") or "")
        made = context.scope.macros[name] = Macro(name, parameters, element, context.source, certain)
        if context.scope is self.scope:
            self.defined.append(made)

    def argument(self, element: Element, _: list[Node], context: Context) -> None:
        default, name = element.attributes.get("default"), element.get("name") or ""
        value = self.evaluate(default.value_span, context) if default is not None else None
        self.pass_by(element, context, goes_in=name not in self.texts.arguments)
        if self.with_defaults and value is not None:
            self.texts.defaults.setdefault(name, value)
        self.texts.arguments.add(name)

    def condition(self, element: Element, into: list[Node], context: Context) -> None:
        written = element.attributes.get("value")
        value = self.evaluate(written.value_span, context) if written else XacroUnknown("")
        holds = truth(value)
        if holds is None and written is not None and not isinstance(value, XacroUnknown):
            self.problem(XacroProblem.CONDITION, written.value_span, shown(value), ())
        self.pass_by(element, context, goes_in=holds in (None, element.tag == "xacro:if"))
        if holds is None:
            self.inside(element, into, replace(context, is_certain=False))
        elif holds is (element.tag == "xacro:if"):
            self.inside(element, into, context)

    def pass_by(self, element: Element, context: Context, *, goes_in: bool) -> None:
        place = (context.source.path, element.span)
        self.found.ways[place] = goes_in or self.found.ways.get(place, False)

    def insert(self, element: Element, into: list[Node], context: Context) -> None:
        name = element.attributes.get("name")
        if name is None or "$" in name.value:
            self.found.is_open = True
            return
        homes = [(context.scope.home(f"{stars}{name.value}"), f"{stars}{name.value}") for stars in ("**", "*")]
        stored: Stored | None = next((home.names[key] for home, key in homes if home is not None), None)
        if isinstance(stored, XacroBlock):
            block = replace(context, source=stored.source, scope=stored.scope)
            if stored.content_only:
                self.inside(stored.element, into, block)
            else:
                self.element(stored.element, into, replace(block, depth=block.depth + 1))
        elif stored is None:
            known = {each.lstrip("*") for each in blocks_in(context.scope)}
            self.problem(XacroProblem.BLOCK, name.value_span, name.value, known)
        else:
            self.found.is_open = True

    def unknown_call(self, element: Element, context: Context) -> None:
        """What a macro makes that is not known: xacro evaluates what it is given all the same."""
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


def blocks_in(scope: XacroScope | None) -> set[str]:
    found: set[str] = set()
    while scope is not None:
        found |= {name for name in scope.names if name.startswith("*")}
        scope = scope.parent
    return found


HANDLERS = {
    "xacro:include": Expander.include,
    "xacro:property": Expander.property,
    "xacro:macro": Expander.macro,
    "xacro:arg": Expander.argument,
    "xacro:if": Expander.condition,
    "xacro:unless": Expander.condition,
    "xacro:insert_block": Expander.insert,
}
