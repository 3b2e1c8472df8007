"""A node that checks what it is asked for, writes it down, and lives among others that talk to it."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import yaml
from rcl_interfaces.msg import ParameterDescriptor, ParameterValue, SetParametersResult

import rclpy
from rclpy.parameter import Parameter
from rclpy.task import Future
from rclpy.time import Time
from rclpy.timer import Timer


class _Publisher:
    def __init__(self, kind: type, topic: str) -> None:
        self.kind, self.topic = kind, topic

    def publish(self, message: object) -> None:
        assert type(message) is self.kind
        rclpy.note("publish", topic=self.topic, data=vars(message))


class _Client:
    def __init__(self, node: Node, kind: Any, name: str) -> None:
        self.node, self.kind, self.name, self.asked = node, kind, name, 0

    def service_is_ready(self) -> bool:
        self.asked += 1
        return self.asked > 2

    def call_async(self, request: Any) -> Future:
        assert type(request) is self.kind.Request
        rclpy.note("call", service=self.name, request=vars(request))
        future = Future()

        def answer() -> None:
            self.node.turns.remove(answer)
            future.set_result(self.kind.Response(sum=request.a + request.b))

        self.node.turns.append(answer)
        return future


class _Logger:
    def __init__(self) -> None:
        self.once: set[str] = set()

    def info(self, text: str, *, once: bool = False) -> None:
        assert isinstance(text, str)
        if not (once and text in self.once):
            print(f"[INFO] {text}", file=sys.stderr)
        self.once.add(text)

    warning = info


class _Parameter:
    def __init__(self, value: object) -> None:
        self.value = value

    def get_parameter_value(self) -> ParameterValue:
        return ParameterValue(self.value)


def overrides(name: str) -> dict[str, object]:
    """Return what the file that STANDIN_PARAMS names says of a node."""
    file = os.environ.get("STANDIN_PARAMS")
    loaded = yaml.safe_load(Path(file).read_text()) if file else {}
    return {
        **loaded.get("/**", {}).get("ros__parameters", {}),
        **loaded.get(f"/**/{name}", {}).get("ros__parameters", {}),
    }


class Node:
    """Takes parameters from a file as rcl does: a value of another type, or outside its range, is an error."""

    def __init__(self, node_name: str) -> None:
        assert rclpy.ok(), "rclpy.init() comes first"
        self.name = node_name
        self.turns: list[Callable[[], None]] = []
        self._declared: dict[str, object] = {}
        self._overrides = overrides(node_name)
        self._logger_of_mine = _Logger()
        rclpy.note("node", name=node_name, kind=type(self).__mro__[1].__name__)

    def declare_parameter(self, name: str, value: object, descriptor: ParameterDescriptor | None = None) -> _Parameter:
        assert name not in self._declared
        given = self._overrides.get(name, value)
        assert type(given) is type(value), f"{name}: {given!r} where {value!r} is expected"
        for allowed in (*descriptor.floating_point_range, *descriptor.integer_range) if descriptor else ():
            assert type(allowed.from_value) is type(allowed.to_value) is type(given)
            assert allowed.from_value <= given <= allowed.to_value
        self._declared[name] = given
        rclpy.note("declare", name=name, value=given, described=bool(descriptor and descriptor.description))
        return _Parameter(given)

    def get_parameter(self, name: str) -> _Parameter:
        return _Parameter(self._declared[name])

    def add_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], SetParametersResult]) -> None:
        """Change each text parameter, and try to empty it."""

        def change() -> None:
            for name, value in self._declared.items():
                for new in ("other", "") if isinstance(value, str) else ():
                    result = callback([Parameter("another", 1), Parameter(name, new)])
                    rclpy.note("change", name=name, value=new, successful=result.successful, reason=result.reason)

        self.turns.append(Timer(0.05, change))

    def create_publisher(self, kind: type, topic: str, depth: int) -> _Publisher:
        assert isinstance(depth, int)
        rclpy.note("publisher", topic=topic, type=f"{kind.__module__}.{kind.__name__}")
        return _Publisher(kind, topic)

    def create_subscription(self, kind: Any, topic: str, callback: Callable[[Any], None], depth: int) -> object:
        assert isinstance(depth, int)
        rclpy.note("subscription", topic=topic, type=f"{kind.__module__}.{kind.__name__}")
        self.turns.append(Timer(0.05, lambda: callback(kind(data="Hello"))))
        return object()

    def create_service(self, kind: Any, name: str, callback: Callable[[Any, Any], Any]) -> object:
        rclpy.note("service", service=name, type=f"{kind.__module__}.{kind.__name__}")

        def call() -> None:
            response = callback(kind.Request(a=2, b=3), kind.Response())
            assert type(response) is kind.Response
            rclpy.note("response", data=vars(response))

        self.turns.append(Timer(0.05, call))
        return object()

    def create_client(self, kind: Any, name: str) -> _Client:
        rclpy.note("client", service=name, type=f"{kind.__module__}.{kind.__name__}")
        return _Client(self, kind, name)

    def create_timer(self, period: float, callback: Callable[[], None]) -> Timer:
        rclpy.note("timer", period=period)
        timer = Timer(period, callback)
        self.turns.append(timer)
        return timer

    def destroy_timer(self, timer: Timer) -> bool:
        assert timer in self.turns
        self.turns.remove(timer)
        return True

    def get_clock(self) -> Time:
        return Time()

    def get_logger(self) -> Any:
        return self._logger_of_mine
