"""Which executables that CMake builds are nodes, and which of them launch files or the README start."""

from __future__ import annotations

import re
from functools import cached_property

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...languages.cpp.lexer import TOKEN
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.target_links import TargetLinks
from ...ros.share_layout import LAUNCH

# Linear: it has to fit a whole name, from its start.
ROS = regex(r"(rclcpp|rclcpp_\w+|\w+_(msgs|interfaces))(_TARGETS|_LIBRARIES)?")
NAMES_ROS = regex(r"\brcl(?:c|cpp)?(?:_\w+)?\b|\brcl(?:c|cpp)?/")
"""What a program has in its own files where it starts a node itself: a name of a client library, or its header."""
STARTS_ROS = regex(r"\b(?:rclcpp::(?:init|spin)|rclc?_init)\b")
RUNS_NODE = regex(
    r"\brclcpp::(?:init|spin|executors)|\brclcpp_lifecycle::|\brclc?_\w*init|\b(?:Lifecycle)?Node\b|\binit\s*\(\s*arg"
)
"""What the code of a program has that runs a node, and not of one that only reads or writes bags."""
EXECUTABLE = regex(r"""\b(?:node_executable|executable|exec)\s*[=:]\s*["']?([\w.-]+)""")
MAX_DEPTH = 4


@dataclass(frozen=True)
class NodePrograms:
    package: CMakePackage

    @cached_property
    def links(self) -> TargetLinks:
        return TargetLinks(self.package.cmake)

    def is_run(self, target: Target) -> bool:
        """Return whether a program is intended for `ros2 run` or a launch file."""
        return target.name in self.started or self.may_be_node(target)

    def may_be_node(self, target: Target) -> bool:
        """Return whether a program starts a node, or its code is not known.

        Its own files have a name of a client library, or a library of the package that it is linked with starts ROS.
        """
        own = self.texts(target)
        return own is None or any(map(NAMES_ROS.search, own)) or self.is_started_by_library(target.name)

    def runs_node(self, target: Target) -> bool:
        """Return whether a program runs a node, or its code is not known: one may use messages without a node."""
        own = self.texts(target)
        return own is None or any(map(RUNS_NODE.search, own)) or self.is_started_by_library(target.name)

    def is_started_by_library(self, name: str, depth: int = 0) -> bool:
        for link in self.links.of(name):
            library = self.links.own(link.word.text)
            if library is None or library.name == name:
                continue
            texts = self.texts(library)
            if texts is None or any(map(STARTS_ROS.search, texts)):
                return True
            if depth < MAX_DEPTH and self.is_started_by_library(library.name, depth + 1):
                return True
        return False

    def texts(self, target: Target) -> list[str] | None:
        """Return the code of the files of a target; None where it has none, or one that is not known."""
        files = self.package.cmake.package_files
        paths = [path_in_package(word.text, target.call.folder) for word in target.sources]
        known = [path for path in paths if path is not None and files.has_file(path)]
        is_whole = bool(paths) and len(known) == len(paths) and target.name not in self.added_to
        return [without_comments(files.readable_text(path)) for path in known] if is_whole else None

    @cached_property
    def added_to(self) -> frozenset[str]:
        """The targets that get sources of target_sources."""
        return frozenset(text for call in self.package.cmake.named("target_sources") for text in call.texts[:1])

    def uses_ros(self, target: str, depth: int = 0) -> bool:
        """Return whether a target is linked with ROS, itself or through another target of the package."""
        for link in self.links.of(target):
            text = link.word.text if link.word.is_known else self.package.cmake.source_text(link.word)
            if ROS.fullmatch(text.strip('"${}').partition("::")[0]):
                return True
            own = self.links.own(text)
            if own is not None and own.name != target and depth < MAX_DEPTH and self.uses_ros(own.name, depth + 1):
                return True
        return False

    @cached_property
    def started(self) -> frozenset[str]:
        """The executables that launch files name, or that the README starts."""
        run = re.compile(rf"ros2\s+run\s+{re.escape(self.package.facts.name)}\s+([\w.-]+)")
        found: set[str] = set()
        for path in self.package.cmake.package_files.paths:
            name = path.rpartition("/")[2]
            if LAUNCH.fullmatch(name):
                found |= set(EXECUTABLE.findall(self.package.cmake.package_files.readable_text(path)))
            elif name.lower().startswith("readme"):
                found |= set(run.findall(self.package.cmake.package_files.readable_text(path)))
        return frozenset(found)


def without_comments(text: str) -> str:
    return TOKEN.sub(lambda found: "" if found[0].startswith(("//", "/*")) else found[0], text)
