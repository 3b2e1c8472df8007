"""Rule input: whether launch files give a robot's xacro argument a value, so that its default is never used."""

from __future__ import annotations

import re

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_words import words_of
from ...package.workspace import Workspace
from .opening_texts import LAUNCH
from .robot_texts import RobotTexts

GIVES = r"\b{0}:=|\bmappings\b[^)]{{0,500}}[\"']{0}[\"']"
KEY = r"[\"']{0}[\"']\s*:"
"""How a launch file gives an argument to xacro: in a command, or as a key of a dict, which may be apart from it."""


@dataclass(frozen=True)
class GivenArguments:
    texts: RobotTexts
    package: PackageFacts
    workspace: Workspace

    def has(self, path: str, argument: str) -> bool:
        """Return whether each launch file that runs xacro and names a robot gives it an argument, and one does.

        A launch file that names another file with the robot's stem in full (`arm.urdf` for `arm.urdf.xacro`) opens
        that one, and does not count.
        """
        name = path.rpartition("/")[2]
        stem = re.compile(rf"\b{re.escape(name.partition('.')[0])}\b")
        given, key = (re.compile(each.format(re.escape(argument))) for each in (GIVES, KEY))
        launches = [text for other, text in self.texts.every if other.endswith(LAUNCH) and "xacro" in text]
        naming = [text for text in launches if stem.search(text) and not opens_other_suffix(name, words_of(text))]
        gives = [bool(given.search(text) or ("mappings" in text and key.search(text))) for text in naming]
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        wanted = {self.package.name, name.partition(".")[0]}
        words = [each for facts in others for each in facts.robot_words if wanted <= each]
        gives += [argument in each for each in words if not opens_other_suffix(name, each)]
        return bool(gives) and all(gives)


def opens_other_suffix(name: str, words: frozenset[str]) -> bool:
    """Return whether words name a file in full that differs from a robot's in the suffix, and not the robot's."""
    start = f"{name.partition('.')[0]}."
    return name not in words and any(each.startswith(start) for each in words)
