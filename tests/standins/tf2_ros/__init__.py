"""A broadcaster that writes down what it sends, and a buffer that knows a frame at the second question."""

from __future__ import annotations

from typing import Any

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.time import Time


class TransformException(Exception):
    pass


class TransformBroadcaster:
    def __init__(self, node: Node) -> None:
        assert isinstance(node, Node)

    def sendTransform(self, transform: TransformStamped) -> None:
        assert isinstance(transform, TransformStamped)
        place = transform.transform.translation.x
        rclpy.note("transform", parent=transform.header.frame_id, child=transform.child_frame_id, x=place)


class Buffer:
    asked = 0

    def lookup_transform(self, target_frame: str, source_frame: str, time: Time) -> Any:
        self.asked += 1
        rclpy.note("look up", target=target_frame, source=source_frame)
        if self.asked < 2:
            raise TransformException("no such frame")
        return TransformStamped()


class TransformListener:
    def __init__(self, buffer: Buffer, node: Node) -> None:
        assert isinstance(buffer, Buffer)
        assert isinstance(node, Node)
