"""A node that checks what it is asked for, and writes it down."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import yaml
from rcl_interfaces.msg import ParameterDescriptor, ParameterValue

import rclpy


class _Timer:
    def __init__(self, period: float, callback: Callable[[], None]) -> None:
        assert period > 0
        self.period, self.callback, self.due = period, callback, time.monotonic()

    def __call__(self) -> None:
        if time.monotonic() >= self.due:
            self.due += self.period
            self.callback()


class _Publisher:
    def __init__(self, kind: type, topic: str) -> None:
        self.kind, self.topic = kind, topic

    def publish(self, message: object) -> None:
        assert type(message) is self.kind
        rclpy.note("publish", topic=self.topic, data=vars(message))


class _Logger:
    def info(self, text: str) -> None:
        assert isinstance(text, str)
        print(f"[INFO] {text}", file=sys.stderr)


class _Parameter:
    def __init__(self, value: object) -> None:
        self.value = value

    def get_parameter_value(self) -> ParameterValue:
        return ParameterValue(self.value)


class Node:
    """Takes parameters from the file that STANDIN_PARAMS names, as rcl does: a value of another type is an error."""

    def __init__(self, node_name: str) -> None:
        assert rclpy.ok(), "rclpy.init() comes first"
        self.name = node_name
        self.timers: list[_Timer] = []
        self._declared: dict[str, object] = {}
        file = os.environ.get("STANDIN_PARAMS")
        loaded = yaml.safe_load(Path(file).read_text()) if file else {}
        self._overrides = loaded.get("/**", {}).get("ros__parameters", {})
        rclpy.note("node", name=node_name)

    def declare_parameter(self, name: str, value: object, descriptor: ParameterDescriptor | None = None) -> _Parameter:
        assert name not in self._declared
        given = self._overrides.get(name, value)
        assert type(given) is type(value), f"{name}: {given!r} where {value!r} is expected"
        self._declared[name] = given
        rclpy.note("declare", name=name, value=given, described=bool(descriptor and descriptor.description))
        return _Parameter(given)

    def get_parameter(self, name: str) -> _Parameter:
        return _Parameter(self._declared[name])

    def create_publisher(self, kind: type, topic: str, depth: int) -> _Publisher:
        assert isinstance(depth, int)
        rclpy.note("publisher", topic=topic, type=f"{kind.__module__}.{kind.__name__}")
        return _Publisher(kind, topic)

    def create_timer(self, period: float, callback: Callable[[], None]) -> _Timer:
        rclpy.note("timer", period=period)
        self.timers.append(_Timer(period, callback))
        return self.timers[-1]

    def get_logger(self) -> Any:
        return _Logger()
