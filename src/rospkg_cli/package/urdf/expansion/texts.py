"""Evaluate texts of xacro: `a${b}$(arg c)`. (xacro/__init__.py: eval_text; substitution_args.py)"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from xml.sax.saxutils import unescape

from ....lazy_regex import regex
from ....light_dataclasses import dataclass, field
from ....source import Span
from .expressions import GLOBAL, NoValueError, evaluate, free_names, parsed
from .values import Value, XacroBlock, XacroPlace, XacroScope, XacroText, XacroUnknown, literal, shown

TOKEN = regex(r"\$\$+[{(]|\$\{[^}]*\}|\$\([^)]*\)|[^$]+|\$")
COMMAND = regex(r"\$\([^)]*\)")
MAX_DEPTH = 40
PACKAGE = "package://"
QUOTES = {"&quot;": '"', "&apos;": "'"}


@dataclass
class TextEvaluator:
    """Evaluates texts in scopes; reads of names that are not there are passed to `undefined`."""

    undefined: Callable[[XacroPlace, str, XacroScope], None]
    undeclared: Callable[[XacroPlace, str], None]
    arguments: set[str] = field(default_factory=set)
    """Those that `<xacro:arg>` has declared so far."""
    defaults: dict[str, Value] = field(default_factory=dict)
    """The values of those that are not given; empty where they may have any."""
    variables: Callable[[str], bool] | None = None
    """Whether anything sets a variable of the environment; where it is not given, each may have any value."""
    depth: int = 0

    def evaluate(self, place: XacroPlace, scope: XacroScope) -> Value:
        """Return the value of the text at a place."""
        raw = place.source.slice(place.span)
        if "$" not in raw:
            return raw
        found: list[Value] = []
        for match in TOKEN.finditer(raw):
            span = Span(place.span.start + match.start(), place.span.start + match.end())
            found.append(self.token(match.group(), XacroPlace(place.source, span), scope))
        if len(found) == 1:
            return found[0]
        text = "".join(map(shown, found))
        return XacroUnknown(text) if any(isinstance(each, XacroUnknown) for each in found) else text

    def token(self, token: str, place: XacroPlace, scope: XacroScope) -> Value:
        if token.startswith("${"):
            return self.expression(token, place, scope)
        if token.startswith("$("):
            return self.command(token, place)
        return token[1:] if token.startswith("$$") else token

    def command(self, token: str, place: XacroPlace) -> Value:
        match token[2:-1].split():
            case ["find", name] if "$" not in name:
                return PACKAGE + name
            case ["dirname"]:
                return "."
            case ["arg", name] if name in self.defaults:
                return self.defaults[name]
            case ["optenv", name, *words] if self.variables is not None and not self.variables(name):
                return " ".join(words)
            case ["arg", name] if name not in self.arguments and "$" not in name:
                self.undeclared(place, name)
        return XacroUnknown(" ".join(token.split()))

    def expression(self, token: str, place: XacroPlace, scope: XacroScope) -> Value:
        inner = self.filled(unescape(token[2:-1], QUOTES), place)
        tree = None if inner is None else parsed(" ".join(inner.split()))
        if tree is None or self.depth > MAX_DEPTH:
            return XacroUnknown(f"{token}{unlike(scope)}")
        names: dict[str, Value] = {}
        for name in free_names(tree):
            home = scope.home(name)
            if home is not None:
                names[name] = self.read(name, home)
            elif name not in GLOBAL:
                self.undefined(place, name, scope)
        if isinstance(tree, ast.Name) and tree.id in names:
            return names[tree.id]
        return folded(tree, names, f"{token}{unlike(scope)}")

    def filled(self, text: str, place: XacroPlace) -> str | None:
        """Return an expression with the commands inside of it replaced, `'$(arg sim)' == 'gz'`; None if unknown."""
        parts: list[str] = []
        at = 0
        for match in COMMAND.finditer(text):
            value = self.command(match.group(), place)
            if isinstance(value, XacroUnknown):
                return None
            parts += [text[at : match.start()], shown(value)]
            at = match.end()
        return "".join([*parts, text[at:]])

    def read(self, name: str, home: XacroScope) -> Value:
        """Return the value of a name in its table; what is read first is evaluated there."""
        stored = home.names[name]
        if isinstance(stored, XacroBlock):
            return XacroUnknown(f"${{{name}}}")
        if not isinstance(stored, XacroText):
            return stored
        home.names[name] = XacroUnknown(f"${{{name}}}")  # a circle ends here
        self.depth += 1
        found = self.evaluate(stored.place, home)
        self.depth -= 1
        home.names[name] = literal(found) if isinstance(found, str) else found
        return home.names[name]  # type: ignore[return-value]


def unlike(scope: XacroScope) -> str:
    """Return a mark that no other scope has, for what is the same only within one."""
    return f"@{scope.number}"


def folded(tree: ast.expr, names: Mapping[str, Value], unique: str) -> Value:
    """Return the value of an expression; texts that are put together stay comparable though parts are unknown."""
    try:
        return evaluate(tree, names)
    except NoValueError:
        text = joined(tree, names)
        return XacroUnknown(unique if text is None else text)


def joined(tree: ast.expr, names: Mapping[str, Value]) -> str | None:
    """Return the text of `a + 'b'`; None for any other expression."""
    match tree:
        case ast.Constant(value=str(text)):
            return text
        case ast.Name(id=name) if isinstance(names.get(name), str | XacroUnknown):
            return shown(names[name])
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            parts = joined(left, names), joined(right, names)
            return None if parts[0] is None or parts[1] is None else parts[0] + parts[1]
    return None
