"""Branches of CMake that only a build with catkin takes, where another branch of the same `if` is for ament."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.command_blocks import Block, commands_in
from ...languages.cmake.syntax import CommandInvocation
from ...package.cmake.cmake_project import CMake
from ...ros.read_table import rows

TABLE = "ros1_commands.txt"
Body = list["CommandInvocation | Block"]


def only_for_ros1(cmake: CMake) -> frozenset[int]:
    """Return the identities of the commands in such branches, of the outermost blocks."""
    blocks = (each for file in cmake.files for each in file.body if isinstance(each, Block))
    return frozenset(id(command) for block in blocks for command in commands_for_ros1(block))


def commands_for_ros1(block: Block) -> Iterator[CommandInvocation]:
    branches = [each.body for each in block.branches]
    has_ament = any(map(is_for_ament, branches))
    for branch in branches:
        if has_ament and is_for_catkin(branch) and not is_for_ament(branch):
            yield from commands_in(branch)


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
