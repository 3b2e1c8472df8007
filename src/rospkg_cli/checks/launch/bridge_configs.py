"""Config files of ros_gz_bridge: a list of topics with their types. (ros_gz_bridge/src/bridge_config.cpp)"""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, documents
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...suggest import nearest
from ...unreadable import UnreadableError
from ..fault import Fault, TextRepair, softer_advice
from ..yaml_elsewhere import is_named_yaml
from .bridge_arguments import BRIDGES, HARM, wrong_groups
from .bridge_pairs import GAZEBO_TYPE, unknown_pair
from .launch_context import LaunchContext

ROS, GAZEBO, DIRECTION = "ros_type_name", "gz_type_name", "direction"
DIRECTIONS = ("BIDIRECTIONAL", "GZ_TO_ROS", "ROS_TO_GZ")
TYPE = regex(r"([a-z]\w*)/(msg|srv)/([A-Z]\w*)")
PIECES = regex(r"([a-z]\w*)(?:::|/|\.)(?:(?:msg|srv)(?:::|/|\.))?([A-Z]\w*)")
"""A type as C++ or Python writes it, or without `msg`: the bridge compares the whole text."""
UNNAMED = "but nothing here names this file"
TOPIC, OWN_TOPICS = "topic_name", ("ros_topic_name", "gz_topic_name")


@dataclass(frozen=True)
class Bridges:
    """What starts bridges, and their config files."""

    scopes: tuple[LaunchContext, ...]
    files: PackageFiles
    workspace: Workspace
    package: PackageFacts

    def config_faults(self) -> Iterator[tuple[str, Fault]]:
        """Yield the wrong types, directions and pairs of keys, with the files that they are in."""
        for path in self.files.paths:
            is_config = path.endswith((".yaml", ".yml")) and role_of(path) not in ("test", "aside")
            if is_config and self.files.holds(path, ROS.encode()):
                is_met = is_named_yaml(path, self.package, self.workspace)
                for fault in (fault for entry in self.entries(path) for fault in self.faults_of(entry)):
                    yield path, fault if is_met else softer_advice(fault, "info", UNNAMED)

    def entries(self, path: str) -> Iterator[dict[str, ScalarNode]]:
        """Yield the scalars of each item of a list of topics."""
        try:
            roots = documents(self.files.source(path))
        except UnreadableError:
            return
        for each in roots[0].items if roots and isinstance(roots[0], SequenceNode) else ():
            if isinstance(each, MappingNode):
                pairs = ((key, value) for key, value in each.entries if isinstance(key, ScalarNode))
                found = {key.text: value for key, value in pairs if isinstance(value, ScalarNode)}
                if ROS in found and GAZEBO in found:
                    yield found

    def faults_of(self, entry: dict[str, ScalarNode]) -> Iterator[Fault]:
        wrong = list(self.type_faults(entry[ROS]))
        yield from wrong or self.pair_faults(entry[ROS], entry[GAZEBO])
        direction = entry.get(DIRECTION)
        if direction is not None and direction.text not in DIRECTIONS and direction.text.isidentifier():
            upper = direction.text.upper()
            near = upper if upper in DIRECTIONS else nearest(upper, DIRECTIONS)
            hint = (
                f"did you mean `{near}`?" if near else f"write one of {', '.join(f'`{each}`' for each in DIRECTIONS)}"
            )
            yield Fault(direction.span, f"`{direction.text}` is no direction: {HARM}; {hint}")
        twice = [name for name in OWN_TOPICS if name in entry and entry[name].text]
        if TOPIC in entry and entry[TOPIC].text and twice:
            yield Fault(entry[TOPIC].span, f"`{TOPIC}` and `{twice[0]}` exclude each other: {HARM}; name one of them")

    def pair_faults(self, ros: ScalarNode, gazebo: ScalarNode) -> Iterator[Fault]:
        if any(self.workspace.named(name) for name in BRIDGES):
            return
        if GAZEBO_TYPE.fullmatch(ros.text) and TYPE.fullmatch(gazebo.text):
            message = f"`{ros.text}` is a type of Gazebo: {HARM}; exchange it with `{gazebo.text}`"
            yield Fault(ros.span, message)
        elif problem := unknown_pair(ros.text, gazebo.text):
            yield Fault(gazebo.span, f"no bridge knows this pair of types: {HARM}; {problem}")

    def type_faults(self, node: ScalarNode) -> Iterator[Fault]:
        found, loose = TYPE.fullmatch(node.text), PIECES.fullmatch(node.text)
        if found is not None:
            wrong = wrong_groups(self.workspace, found.group(1), found.group(2), found.group(3))
            better = next((f"`{near}`" for _, near in wrong), "")
            if better:
                yield Fault(node.span, f"there is no `{node.text}`: {HARM}; did you mean {better}?")
        elif loose is not None:
            intended = f"{loose.group(1)}/msg/{loose.group(2)}"
            written = node.located.text == node.text and not node.tag
            repair = TextRepair(f"write `{intended}`", ((node.located.span, intended),)) if written else None
            message = f"the bridge knows no type `{node.text}`: {HARM}; write `{intended}`"
            yield Fault(node.span, message, repair=repair)
