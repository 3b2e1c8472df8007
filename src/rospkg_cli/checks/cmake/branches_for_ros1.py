"""Branches of CMake that only a build with catkin takes, beside one for ament of the same `if`."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.command_blocks import Block
from ...languages.cmake.syntax import CommandInvocation
from ...package.cmake.cmake_project import CMake
from ...ros.read_table import rows

TABLE = "ros1_commands.txt"
Body = list["CommandInvocation | Block"]


def only_for_ros1(cmake: CMake) -> frozenset[int]:
    """Return the identities of the commands in such branches."""
    return frozenset(id(command) for file in cmake.files for command in commands_for_ros1(file.body))


def commands_for_ros1(body: Body) -> Iterator[CommandInvocation]:
    for block in body:
        if isinstance(block, Block):
            branches = [each.body for each in block.branches]
            has_ament = any(map(is_for_ament, branches))
            for branch in branches:
                is_old = has_ament and is_for_catkin(branch) and not is_for_ament(branch)
                yield from commands_in(branch) if is_old else commands_for_ros1(branch)


def is_for_catkin(body: Body) -> bool:
    return any(
        (each.name == "find_package" and first_of(each) == "catkin") or each.name in rows(TABLE)
        for each in commands_in(body)
    )


def is_for_ament(body: Body) -> bool:
    return any(
        (each.name == "find_package" and first_of(each).startswith("ament_")) or each.name.startswith("ament_")
        for each in commands_in(body)
    )


def first_of(command: CommandInvocation) -> str:
    return command.arguments[0].text if command.arguments else ""


def commands_in(body: Body) -> Iterator[CommandInvocation]:
    for each in body:
        if isinstance(each, CommandInvocation):
            yield each
        else:
            for branch in each.branches:
                yield from commands_in(branch.body)
