"""Read XML and YAML launch files."""

from __future__ import annotations

import posixpath

from ...languages.syntax_problem import SyntaxProblem
from ...source import Source
from .entity import Entity, from_xml, from_yaml
from .entity_events import xml_events
from .entity_reader import EntityVisitor
from .launch_file import Frontend, LaunchFile
from .ros1 import is_named_ros1, is_ros1


def read_xml_launch(source: Source) -> LaunchFile | None:
    """Read an XML launch file; None where it is some other XML; raises UnreadableError."""
    root = from_xml(source)
    return launch_file(source, "xml", root, []) if root.name == "launch" and not is_of_another(root) else None


def is_of_another(root: Entity) -> bool:
    """Return whether it is a list for a program of its own: it has nodes, and none names a package or a program."""
    nodes = [each for each in root.walk() if each.name == "node"]
    return bool(nodes) and not any({"pkg", "package", "exec", "type"} & each.attributes.keys() for each in nodes)


def read_yaml_launch(source: Source) -> LaunchFile | None:
    """Read a YAML launch file; None where it is some other YAML; raises UnreadableError."""
    root, problems = from_yaml(source)
    return launch_file(source, "yaml", root, problems) if root is not None and root.name == "launch" else None


def launch_file(source: Source, frontend: Frontend, root: Entity, problems: list[SyntaxProblem]) -> LaunchFile:
    """Return what the entities of a file say; `problems` are those of its syntax, to which others are added."""
    visitor = EntityVisitor(problems)
    visitor.visit(root, True)
    return LaunchFile(
        source,
        frontend,
        tuple(visitor.nodes),
        tuple(visitor.includes),
        tuple(visitor.arguments),
        tuple(visitor.commands),
        tuple(found for text in visitor.texts for found in text.substitutions()),
        tuple(visitor.assigned),
        every_path=tuple(dict.fromkeys(visitor.paths(posixpath.dirname(source.path)))),
        events=xml_events(root),
        is_ros1=is_named_ros1(source.path) or is_ros1(root),
        root=root,
        syntax_problems=tuple(visitor.problems),
    )
