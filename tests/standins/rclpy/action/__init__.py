"""Actions with somebody at the other end: goals for a server, a server for a client."""

from __future__ import annotations

import threading
from collections.abc import Callable
from enum import Enum
from typing import Any

import rclpy
from rclpy.action.server import ServerGoalHandle
from rclpy.node import Node
from rclpy.task import Future
from rclpy.timer import Timer


class GoalResponse(Enum):
    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    REJECT = 1
    ACCEPT = 2


ORDERS = (0, 47, 5, 40)
"""The goals that a server gets; the last one is cancelled."""


class ActionServer:
    def __init__(
        self,
        node: Node,
        action_type: Any,
        action_name: str,
        execute_callback: Callable[[ServerGoalHandle], Any],
        *,
        callback_group: object = None,
        goal_callback: Callable[[Any], GoalResponse] = lambda goal: GoalResponse.ACCEPT,
        cancel_callback: Callable[[Any], CancelResponse],
    ) -> None:
        rclpy.note("action server", name=action_name, group=type(callback_group).__name__)
        self.type, self.execute, self.judge, self.may_cancel = (
            action_type,
            execute_callback,
            goal_callback,
            cancel_callback,
        )
        self.left = list(ORDERS)
        node.turns.append(Timer(0.05, self.send))

    def send(self) -> None:
        if not self.left:
            return
        order = self.left.pop(0)
        goal = self.type.Goal(order=order)
        answer = self.judge(goal)
        assert isinstance(answer, GoalResponse)
        rclpy.note("goal", order=order, accepted=answer is GoalResponse.ACCEPT)
        if answer is GoalResponse.ACCEPT:
            threading.Thread(target=self.run, args=(goal, not self.left)).start()

    def run(self, goal: Any, cancel: bool) -> None:
        handle = ServerGoalHandle(self.type, goal)
        if cancel:
            assert self.may_cancel(handle) is CancelResponse.ACCEPT
            handle.is_cancel_requested = True
        result = self.execute(handle)
        assert type(result) is self.type.Result
        rclpy.note("result", order=goal.order, state=handle.state, sequence=list(result.sequence))


class _ClientGoalHandle:
    accepted = True

    def __init__(self, sequence: list[int], result: Any) -> None:
        self.sequence, self.result = sequence, result

    def get_result_async(self) -> Future:
        future = Future()
        wrapped = type("GetResult", (), {"result": self.result(sequence=self.sequence), "status": 4})
        future.set_result(wrapped)
        return future


class ActionClient:
    def __init__(self, node: Node, action_type: Any, action_name: str) -> None:
        rclpy.note("action client", name=action_name)
        self.type, self.asked = action_type, 0

    def server_is_ready(self) -> bool:
        self.asked += 1
        return self.asked > 1

    def send_goal_async(self, goal: Any, feedback_callback: Callable[[Any], None]) -> Future:
        assert type(goal) is self.type.Goal
        rclpy.note("goal", order=goal.order)
        sequence = [1] * goal.order
        for length in range(1, goal.order + 1):
            feedback = self.type.Feedback(sequence=sequence[:length])
            feedback_callback(self.type.Impl.FeedbackMessage(feedback=feedback))
        future = Future()
        future.set_result(_ClientGoalHandle(sequence, self.type.Result))
        return future
