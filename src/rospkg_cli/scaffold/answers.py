"""What was asked for, and the answers that a template gets: every one checked, none missing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..light_dataclasses import dataclass, replace
from ..ros.distros import Distro
from ..ros.licenses import License
from .bringup import Bringup
from .interface import RequestedInterface
from .node_kinds import NodeParameter
from .plugin import RequestedPlugin
from .requested_node import RequestedNode
from .user_text import UserText

EVERY_NODE = "/**"
"""The key of parameters for every node in every namespace."""


@dataclass(frozen=True)
class Request:
    """What was typed; "", () and 0 where nothing was."""

    name: str
    template: str = "ament_python"
    nodes: tuple[str, ...] = ()
    """`NAME`, `NAME:KIND` or `NAME:KIND:LANGUAGE`; `PACKAGE/EXECUTABLE` where nodes of others are started."""
    depends: tuple[str, ...] = ()
    msgs: tuple[str, ...] = ()
    """`NAME` or `NAME:FIELDS`; so are the next two."""
    srvs: tuple[str, ...] = ()
    actions: tuple[str, ...] = ()
    launch: str = ""
    """`py`, `xml`, `yaml` or `none`."""
    params: bool = True
    tests: str = ""
    """`ament`, `minimal` or `none`."""
    extras: tuple[str, ...] = ()
    """What `--with` adds."""
    own_template: str = ""
    """A folder or the address of a git repository, in the place of `template`."""
    description: str = ""
    license: str = ""
    maintainer: str = ""
    email: str = ""
    version: str = ""
    distro: str = ""
    year: int = 0
    minimal: bool = False
    """Whether what nothing is built, run or tested with is left out."""
    plugins: tuple[str, ...] = ()
    """`KIND` or `NAME:KIND`."""
    parameters: str = ""
    """`file` or `generate`, who declares them; `params` says whether there is a file of values."""

    def with_defaults(self, defaults: Mapping[str, str]) -> Request:
        """Return the request with a config's values where nothing was typed."""
        missing: dict[str, Any] = {key: value for key, value in defaults.items() if not getattr(self, key)}
        return replace(self, **missing)


@dataclass(frozen=True)
class Answers:
    name: str
    nodes: tuple[RequestedNode, ...]
    started: Bringup
    """What it starts of other packages."""
    interfaces: tuple[RequestedInterface, ...]
    depends: tuple[str, ...]
    """What was asked for besides what the template needs: sorted, each once."""
    test_depends: tuple[str, ...]
    """The same, of what only tests use."""
    description: UserText
    license: License
    maintainer: UserText
    email: str
    version: str
    distro: Distro
    year: int
    launch: str
    """`py`, `xml` or `yaml`; "" for no launch file."""
    params: bool
    """Whether there is a file of parameters for nodes that have some."""
    tests: str
    """`ament`, `minimal` or `none`."""
    plugins: tuple[RequestedPlugin, ...] = ()

    @property
    def robot(self) -> str:
        """The robot that a package of its own describes or starts."""
        return self.name.removesuffix("_description").removesuffix("_bringup")

    def nodes_in(self, language: str) -> tuple[RequestedNode, ...]:
        return tuple(node for node in self.nodes if node.language == language)

    def logics_in(self, language: str) -> tuple[str, ...]:
        """The modules of a language's nodes that need no ROS, each once."""
        return tuple(dict.fromkeys(node.kind.logic for node in self.nodes_in(language) if node.kind.logic))

    def messages_in(self, language: str) -> tuple[str, ...]:
        """The packages of the messages that a language's nodes use, each once."""
        used = [package for node in self.nodes_in(language) for package in node.kind.interfaces]
        return tuple(package for package in dict.fromkeys(used) if package != self.name)

    @property
    def interface_packages(self) -> tuple[str, ...]:
        """The packages of the messages that the interfaces are made of, each once."""
        used = [package for interface in self.interfaces for package in interface.packages]
        if self.distro.name == "humble" and any(interface.form == "action" for interface in self.interfaces):
            used.append("action_msgs")  # later distributions bring it with rosidl itself
        return tuple(package for package in dict.fromkeys(used) if package != self.name)

    @property
    def sections(self) -> dict[str, tuple[NodeParameter, ...]]:
        """The parameters of the file, by the key of their block: one block where all nodes that have some have the
        same."""
        if not self.params:
            return {}
        having = {node.name: node.kind.parameters for node in self.nodes if node.kind.parameters}
        if len(set(having.values())) == 1:
            return {EVERY_NODE: next(iter(having.values()))}
        return {f"{EVERY_NODE}/{name}": parameters for name, parameters in having.items()}

    def section_of(self, node: RequestedNode) -> str:
        """Return the key of a node's block in the file of parameters; "" for a node that has none there."""
        if not self.sections or not node.kind.parameters:
            return ""
        return EVERY_NODE if EVERY_NODE in self.sections else f"{EVERY_NODE}/{node.name}"

    @property
    def copyright(self) -> UserText:
        return UserText(f"Copyright {self.year} {self.maintainer.text}")
