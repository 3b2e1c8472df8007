"""Read the entities of an XML or YAML launch file: nodes, includes, arguments, commands."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.located_text import LocatedText
from ...languages.syntax_problem import SyntaxProblem
from ...light_dataclasses import dataclass, field
from ...ros.launch_entities import ACTIONS
from ...source import Span
from .argument_defaults import literal_defaults
from .entity import Entity
from .file_references import FileReference, ReferenceKind, references_in
from .launched_parts import Command, DeclaredArgument, Include, LaunchedNode, NodeKind, NodeParameters
from .substitution import SubstitutionError, parse_text
from .text import LaunchText, Literal, plain_text, unknown_text

NODES: dict[str, NodeKind] = {
    "node": "node",
    "lifecycle_node": "lifecycle_node",
    "node_container": "node_container",
}
TYPED = frozenset({"value-sep", "type"})
"""Attributes that make another value of the text of a parameter: a list of its parts, or one of a named type."""


@dataclass
class EntityVisitor:
    """One pass over the entities of a file."""

    problems: list[SyntaxProblem] = field(default_factory=list)
    texts: list[LaunchText] = field(default_factory=list)
    nodes: list[LaunchedNode] = field(default_factory=list)
    includes: list[Include] = field(default_factory=list)
    arguments: list[DeclaredArgument] = field(default_factory=list)
    commands: list[Command] = field(default_factory=list)
    assigned: list[LaunchText] = field(default_factory=list)

    def text(self, written: LocatedText) -> LaunchText:
        """Parse a value; what the grammar refuses becomes an error and an unknown text."""
        try:
            found = parse_text(written)
        except SubstitutionError as error:
            span = written.part(error.at, min(error.at + 1, len(written.text)))
            self.problems.append(SyntaxProblem(span, error.code, error.details))
            return unknown_text(written.span)
        self.texts.append(found)
        return found

    def paths(self, folder: str) -> Iterator[FileReference]:
        """Yield the files that the texts of a file in `folder` name."""
        uses: dict[Span, ReferenceKind] = {include.file.span: "include" for include in self.includes}
        uses |= {each.default.span: "default" for each in self.arguments if each.default is not None}
        defaults = literal_defaults(self.arguments, self.assigned)
        for text in self.texts:
            yield from references_in(text, folder, uses.get(text.span, "file"), defaults)

    def get(self, entity: Entity, name: str) -> LaunchText | None:
        written = entity.attributes.get(name)
        return None if written is None else self.text(written)

    def need(self, entity: Entity, name: str) -> LaunchText:
        """Return an attribute that has to be there; where it is absent, an unknown text."""
        found = self.get(entity, name)
        return unknown_text(entity.name_span) if found is None else found

    def visit(self, entity: Entity, certain: bool) -> None:
        """Read an action and its children."""
        certain = certain and not {"if", "unless"} & entity.attributes.keys()
        for name in ("if", "unless"):
            self.get(entity, name)
        match entity.name:
            case "node" | "lifecycle_node" | "node_container":
                self.nodes.append(self.node(entity, NODES[entity.name], certain))
            case "include":
                self.includes.append(self.include(entity, certain))
            case "arg":
                self.arguments.append(self.argument(entity, certain))
            case "executable":
                self.commands.append(Command(entity.name_span, (self.need(entity, "cmd"),)))
            case "let" | "set_parameter" | "set_env" | "append_env":
                assigned = self.need(entity, "name")
                self.get(entity, "value")
                if entity.name == "let":
                    self.assigned.append(assigned)
            case _:
                for written in entity.attributes.values():
                    self.text(written)
        for child in entity.named("composable_node"):
            self.nodes.append(self.node(child, "composable_node", certain))
        kind = ACTIONS.get(entity.name)
        if kind is None or kind.actions:
            for child in entity.children:
                self.visit(child, certain)

    def node(self, entity: Entity, kind: NodeKind, certain: bool) -> LaunchedNode:
        certain = certain and not {"if", "unless"} & entity.attributes.keys()
        arguments = [self.get(entity, name) for name in ("args", "ros_args", "output", "launch-prefix", "cwd")]
        for child in entity.named("env"):
            self.get(child, "value")
        return LaunchedNode(
            kind,
            entity.name_span,
            package=self.get(entity, "pkg"),
            executable=self.get(entity, "exec"),
            plugin=self.get(entity, "plugin"),
            name=self.get(entity, "name"),
            namespace=self.get(entity, "namespace"),
            parameters=tuple(self.parameters(child) for child in entity.named("param")),
            remappings=tuple((self.need(c, "from"), self.need(c, "to")) for c in entity.named("remap")),
            arguments=tuple(text for text in arguments[:2] if text is not None),
            is_certain=certain,
        )

    def parameters(self, entity: Entity) -> NodeParameters:
        file = self.get(entity, "from")
        if file is not None:
            return NodeParameters(entity.span, file)
        return NodeParameters(entity.span, None, tuple(self.values(entity, ())))

    def values(self, entity: Entity, above: tuple[LaunchText, ...]) -> list[tuple[LaunchText, LaunchText]]:
        """Return the parameters that an entity gives, nested ones by their dotted name."""
        name = self.need(entity, "name")
        for each in entity.lists.get("value", ()):
            self.text(each)
        inner = [pair for child in entity.named("param") for pair in self.values(child, (*above, name))]
        if inner:
            return inner
        dotted = name if not above else joined([*above, name])
        value = self.get(entity, "value")
        is_plain = value is not None and TYPED.isdisjoint(entity.attributes)
        return [(dotted, value if value is not None and is_plain else unknown_text(entity.span))]

    def include(self, entity: Entity, certain: bool) -> Include:
        given = tuple((self.need(c, "name"), self.need(c, "value")) for c in entity.named("arg", "let"))
        return Include(entity.name_span, self.need(entity, "file"), given, certain)

    def argument(self, entity: Entity, certain: bool) -> DeclaredArgument:
        choices = tuple(c.attributes["value"].text for c in entity.named("choice") if "value" in c.attributes)
        name = entity.attributes.get("name")
        text = plain_text(name.text, name.span) if name else unknown_text(entity.name_span)
        certain = certain and all(map(ACTIONS["arg"].takes, entity.attributes))  # else launch refuses the whole file
        return DeclaredArgument(entity.name_span, text, self.get(entity, "default"), choices, certain)


def joined(names: list[LaunchText]) -> LaunchText:
    """Join names with dots."""
    parts = list(names[0].parts)
    for name in names[1:]:
        parts += [Literal(".", name.span), *name.parts]
    return LaunchText(Span(names[0].span.start, names[-1].span.end), tuple(parts))
