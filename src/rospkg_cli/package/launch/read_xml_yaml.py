"""Read XML and YAML launch files."""

from __future__ import annotations

from ...source import Source
from .entity import Entity, from_xml, from_yaml
from .entity_reader import launch_file
from .launch_file import LaunchFile


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
