"""A node as it was asked for, with all that follows from that."""

from __future__ import annotations

import re

from ..light_dataclasses import dataclass
from .message import Message
from .node_kinds import NodeKind
from .qos import DEFAULT, QualityOfService


@dataclass(frozen=True)
class RequestedNode:
    name: str
    kind: NodeKind
    language: str
    """One of LANGUAGES."""
    message: Message | None = None
    """The interface that it is all about."""
    qos: QualityOfService = DEFAULT
    parts: tuple[RequestedNode, ...] = ()
    """What a node with several interfaces is made of, each as a node of its own would be."""
    is_generated: bool = False
    """Whether generate_parameter_library makes the code that declares its parameters."""

    @property
    def definitions(self) -> str:
        """The name of the YAML file that its parameters are generated from, of that code and of its namespace; "" where
        none is generated."""
        return f"{self.name}_parameters" if self.is_generated else ""

    @property
    def declares(self) -> bool:
        """Whether its own source declares parameters."""
        return bool(self.kind.parameters) and not self.is_generated

    @property
    def headers(self) -> list[str]:
        """The headers of the interfaces of its parts, each once."""
        messages = [part.message for part in self.parts if part.message]
        return sorted({f"{each.package}/{each.form}/{each.header}.hpp" for each in messages})

    @property
    def qos_imports(self) -> list[str]:
        """What its parts need of rclpy.qos, each once."""
        return sorted({name for part in self.parts for name in part.qos.imports})

    @property
    def senders(self) -> tuple[RequestedNode, ...]:
        """The parts that send at a steady rate."""
        return tuple(part for part in self.parts if part.kind.parameters)

    @property
    def topic(self) -> str:
        """The topic, service or action that it is about; "" where there is none."""
        return self.kind.uses[0].name if self.kind.uses else ""

    @property
    def word(self) -> str:
        """The name of the topic, service or action as a part of names in code."""
        return re.sub(r"\W+", "_", self.topic.strip("~/")).lower()

    @property
    def alias(self) -> str:
        """The name of its interface in C++, where a node has several."""
        return "".join(word.capitalize() for word in self.word.split("_")) + "Type"

    @property
    def class_name(self) -> str:
        """`TalkerNode` for `talker` and for `talker_node`: never the name of a class that a node imports."""
        camel = "".join(word.capitalize() for word in self.name.split("_"))
        return camel if camel.endswith("Node") and camel != "Node" else camel + "Node"
