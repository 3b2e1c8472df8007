"""A lifecycle that `spin` goes through: up to active, down again, and once more up to a shutdown."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple

import rclpy
from rclpy.node import Node, _Publisher


class TransitionCallbackReturn(Enum):
    SUCCESS = 0
    FAILURE = 1
    ERROR = 2


class LifecycleState(NamedTuple):
    label: str
    state_id: int


class LifecyclePublisher(_Publisher):
    """Publishes nothing unless it is active; says so, for a test to see."""

    active = False

    def publish(self, message: object) -> None:
        if self.active:
            super().publish(message)
        else:
            rclpy.note("publish while inactive")


PATH = ("configure", "activate", "deactivate", "cleanup", "configure", "activate", "shutdown")


class LifecycleNode(Node):
    def __init__(self, node_name: str) -> None:
        super().__init__(node_name)
        self._managed: list[LifecyclePublisher] = []
        self._path = list(PATH)
        self._waited = 0
        self.turns.append(self._next)

    def _next(self) -> None:
        """Go one step each 0.2 s or so."""
        self._waited += 1
        if self._waited % 20 or not self._path:
            return
        name = self._path.pop(0)
        done = getattr(self, f"on_{name}")(LifecycleState("", 0))
        assert done is TransitionCallbackReturn.SUCCESS
        rclpy.note("transition", name=name)

    def create_lifecycle_publisher(self, kind: type, topic: str, depth: int) -> LifecyclePublisher:
        rclpy.note("publisher", topic=topic, type=f"{kind.__module__}.{kind.__name__}")
        self._managed.append(LifecyclePublisher(kind, topic))
        return self._managed[-1]

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher) -> bool:
        self._managed.remove(publisher)
        return True

    def _all(self, active: bool) -> TransitionCallbackReturn:
        for publisher in self._managed:
            publisher.active = active
        return TransitionCallbackReturn.SUCCESS

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._all(True)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._all(False)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        assert not self._managed, "what on_configure made is still there"
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        assert not self._managed, "what on_configure made is still there"
        return self._all(False)
