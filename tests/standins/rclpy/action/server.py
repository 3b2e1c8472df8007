"""A goal as its server sees it."""

from __future__ import annotations

from typing import Any

import rclpy


class ServerGoalHandle:
    def __init__(self, action_type: Any, goal: Any) -> None:
        self.type, self.request = action_type, goal
        self.is_cancel_requested = False
        self.state = "executing"

    def publish_feedback(self, feedback: Any) -> None:
        assert type(feedback) is self.type.Feedback
        rclpy.note("feedback", order=self.request.order, sequence=list(feedback.sequence))

    def _end(self, state: str) -> None:
        assert self.state == "executing", "a goal ends once"
        self.state = state

    def succeed(self) -> None:
        self._end("succeeded")

    def canceled(self) -> None:
        assert self.is_cancel_requested
        self._end("canceled")

    def abort(self) -> None:
        assert rclpy.ok()
        self._end("aborted")
