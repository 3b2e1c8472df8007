"""What the XML and YAML frontends of launch know: entities, their attributes, and the entities inside of them.

Packages may add actions of their own.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ..light_dataclasses import dataclass
from .read_table import rows, unfolded

TABLE = "launch_entities.txt"


@dataclass(frozen=True)
class EntityKind:
    required: frozenset[str] = frozenset()
    optional: frozenset[str] = frozenset()
    inside: frozenset[str] = frozenset()
    """Child entities that set an attribute."""
    actions: bool = False
    """Whether it may contain other actions."""
    open: bool = False
    """Whether it may have any other attributes and children."""

    def takes(self, attribute: str) -> bool:
        name = attribute.removesuffix("-sep")
        return self.open or name in self.required or name in self.optional

    @property
    def attributes(self) -> frozenset[str]:
        return self.required | self.optional


def entity(words: Iterable[str]) -> EntityKind:
    """Read `name! name … <part> <...> ...`: required and optional attributes, entities inside, actions, anything."""
    found = list(unfolded(words, rows(TABLE, "sets")))
    attributes = [word for word in found if word[0] not in "<."]
    return EntityKind(
        required=frozenset(word[:-1] for word in attributes if word.endswith("!")),
        optional=frozenset(word for word in attributes if not word.endswith("!")),
        inside=frozenset(word[1:-1] for word in found if word[0] == "<") - {"..."},
        actions="<...>" in found,
        open="..." in found,
    )


LAUNCH_SUFFIXES = ("launch.py", "launch.xml", "launch.yaml", "launch.yml", ".launch", ".xml", ".yaml", ".yml")
"""What the names of launch files end in, for `ros2 launch` to complete them (ros2launch, and both frontends)."""

ACTIONS: Mapping[str, EntityKind] = {name: entity(words) for name, words in rows(TABLE, "actions").items()}

BEFORE_LIFECYCLE_NODE = frozenset({"humble", "jazzy", "kilted"})
"""The distributions whose XML and YAML frontends know no `lifecycle_node` (ros2/launch_ros#482 came later)."""

PARTS: Mapping[str, EntityKind] = {name: entity(words) for name, words in rows(TABLE, "parts").items()}

INCLUDE_ARGUMENT = entity(("name!", "value!", "description", "if", "unless"))
"""`<arg>` inside of `<include>`."""

ROS1_ONLY = frozenset({"machine", "rosparam", "test"})
"""Elements of ROS 1 launch files that ROS 2 does not have."""

ROS1_ENTITIES: Mapping[str, str] = {
    "param": "`<param>` inside of a node, or `<set_parameter>`",
    "rosparam": '`<param from="…"/>` inside of a node',
    "remap": "`<remap>` inside of a node, or `<set_remap>`",
    "env": "`<set_env>`",
    "machine": "",
}
"""Elements that ROS 1 takes among actions and ROS 2 does not, and what replaces each."""

ROS1_SUBSTITUTIONS: Mapping[str, str] = {"find": "find-pkg-share", "arg": "var", "optenv": ""}
"""Substitutions of ROS 1 that ROS 2 does not have, and what each is called now; "" where another form is needed."""

SUBSTITUTIONS: Mapping[str, tuple[int, int]] = {
    name: (int(least), int(most)) for name, (least, most) in rows(TABLE, "substitutions").items()
}
"""Substitutions and how many arguments they take, at least and at most."""
