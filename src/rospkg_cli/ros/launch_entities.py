"""What the XML and YAML frontends of launch know: entities, their attributes, and the entities inside of them.

Source: `parse` of each exposed action in ros2/launch and ros2/launch_ros.  Packages may add actions of their own.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class EntityKind:
    required: frozenset[str] = frozenset()
    optional: frozenset[str] = frozenset()
    inside: frozenset[str] = frozenset()
    """Entities that stand for an attribute."""
    actions: bool = False
    """Whether other actions stand inside."""
    open: bool = False
    """Whether anything else may stand there as well."""

    def takes(self, attribute: str) -> bool:
        name = attribute.removesuffix("-sep")
        return self.open or name in self.required or name in self.optional

    @property
    def attributes(self) -> frozenset[str]:
        return self.required | self.optional


def kind(required: str = "", optional: str = "", inside: str = "", *, actions: bool = False) -> EntityKind:
    """Make a kind of action: each may be under a condition."""
    some = frozenset(f"{optional} if unless".split())
    return EntityKind(frozenset(required.split()), some, frozenset(inside.split()), actions)


def part(required: str = "", optional: str = "", inside: str = "") -> EntityKind:
    """Make a kind of entity that stands for an attribute."""
    return EntityKind(frozenset(required.split()), frozenset(optional.split()), frozenset(inside.split()))


PROCESS = (
    "cwd name on_exit launch-prefix output respawn respawn_max_retries respawn_delay sigkill_timeout sigterm_timeout "
    "shell emulate_tty"
)
NODE = f"{PROCESS} pkg namespace args ros_args node-name exec_name"

LAUNCH_SUFFIXES = ("launch.py", "launch.xml", "launch.yaml", "launch.yml", ".launch", ".xml", ".yaml", ".yml")
"""What the names of launch files end in, for `ros2 launch` to complete them (ros2launch, and both frontends)."""

ACTIONS: Mapping[str, EntityKind] = {
    "launch": EntityKind(actions=True, open=True),
    "arg": kind("name", "default description", "choice"),
    "include": kind("file", "", "arg let"),
    "executable": kind("cmd", PROCESS, "env"),
    "node": kind("exec", NODE, "env remap param"),
    "lifecycle_node": kind("exec name", f"{NODE} autostart", "env remap param"),
    "node_container": kind("exec name namespace", NODE, "env remap param composable_node"),
    "load_composable_node": kind("target", "", "composable_node"),
    "group": kind("", "scoped forwarding", "keep", actions=True),
    "let": kind("name value"),
    "log": kind("message", "level"),
    "set_env": kind("name value"),
    "append_env": kind("name value", "prepend separator"),
    "unset_env": kind("name"),
    "reset_env": EntityKind(open=True),
    "reset": kind("", "", "keep"),
    "timer": kind("period", "cancel_on_shutdown", actions=True),
    "ros_timer": kind("period", actions=True),
    "shutdown": kind("", "reason"),
    "push_ros_namespace": kind("namespace"),
    "push-ros-namespace": kind("namespace"),
    "set_parameter": kind("name value"),
    "set_parameters_from_file": kind("filename", "node"),
    "set_remap": kind("from to"),
    "set_use_sim_time": kind("value"),
    "set_ros_log_dir": kind("new_log_dir"),
}

BEFORE_LIFECYCLE_NODE = frozenset({"humble", "jazzy", "kilted"})
"""The distributions whose XML and YAML frontends know no `lifecycle_node` (ros2/launch_ros#482 came later)."""

PARTS: Mapping[str, EntityKind] = {
    "choice": part("value"),
    "env": part("name value"),
    "keep": part("name value"),
    "remap": part("from to"),
    "extra_arg": part("name value"),
    "param": part("", "name value from type allow_substs", "param"),
    "composable_node": part("pkg plugin name", "namespace if unless", "param remap extra_arg"),
}

INCLUDE_ARGUMENT = part("name value", "description if unless")
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
"""Elements that ROS 1 takes among actions and ROS 2 does not, and what stands for each."""

ROS1_SUBSTITUTIONS: Mapping[str, str] = {"find": "find-pkg-share", "arg": "var", "optenv": ""}
"""Substitutions of ROS 1 that ROS 2 does not have, and what each is called now; "" where another form is needed."""

SUBSTITUTIONS: Mapping[str, tuple[int, int]] = {
    "if": (1, 3),
    "dirname": (0, 0),
    "filename": (0, 0),
    "not": (1, 1),
    "and": (2, 2),
    "or": (2, 2),
    "any": (0, 99),
    "all": (0, 99),
    "var": (1, 2),
    "not-equals": (1, 2),
    "equals": (1, 2),
    "launch_log_dir": (0, 0),
    "log_dir": (0, 0),
    "command": (1, 2),
    "env": (1, 2),
    "find-exec": (1, 1),
    "file-content": (1, 1),
    "eval": (1, 99),
    "anon": (1, 1),
    "exec-in-pkg": (2, 2),
    "find-pkg-prefix": (1, 1),
    "find-pkg-share": (1, 1),
    "param": (1, 1),
}
"""Substitutions and how many arguments they take, at least and at most."""
