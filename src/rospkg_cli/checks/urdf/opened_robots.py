"""Rule input: whether anything opens a robot description of a package, as far as the texts of the package say."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_words import may_be_made, words_of
from ...package.workspace import Workspace
from .included_paths import includes_path
from .named_with_folder import NamedWithFolder
from .opening_texts import LAUNCH, ROBOTS, opening_texts
from .xacro_calls import may_include

if TYPE_CHECKING:
    from .named_elsewhere import NamedElsewhere

XACRO = (".urdf", ".xacro")
ENDS = r"(?!\.(?:xacro|urdf)\b)"
"""Behind the name of a file stands no other suffix: then it is that of another file."""
PAGES = (".md", ".rst", ".txt")
LETTERS = regex(r"[^\W\d_]{2}")
COMMAND = r"(?:\b(?:ros2|xacro\w*|check_urdf|urdf_to_\w+|rviz2?|gz|gazebo|ign|python3?)[\s(]|:=)"
"""What stands in a line of a page that tells how to open a robot; others only tell that it is there."""
GIVES = r"\b{0}:=|\bmappings\b[^)]{{0,500}}[\"']{0}[\"']"
KEY = r"[\"']{0}[\"']\s*:"
"""How a launch file gives an argument to xacro, in a command or in a table, which may stand elsewhere."""
LOOKS = "MoveItConfigsBuilder"
"""MoveIt looks for the robot by its name alone."""


@dataclass(frozen=True)
class OpenedRobots:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def has(self, path: str) -> bool:
        """Return whether a file may be opened: a text of the package names it, or one of a package that names this.

        Robots name files in full; launch files and code often put the suffix behind a name, which then has letters:
        `1` stands everywhere. A robot that names a file opens it where something opens the robot.
        """
        if path not in self._opened:
            self._opened[path] = any(self.is_opened_itself(each) for each in (path, *self.including(path)))
        return self._opened[path]

    @cached_property
    def _opened(self) -> dict[str, bool]:
        """The answers so far: each robot is asked for by several rules, and with those that include it."""
        return {}

    def is_opened_itself(self, path: str) -> bool:
        """Return whether something else than a robot of the package may open a file."""
        if self.is_other_copy(path):
            return False
        may_be = not self.is_copy(path) and (self.is_put_together(path) or self.is_named_elsewhere(path))
        return may_be or any(not other.endswith(XACRO) for other in self.naming(path))

    def including(self, path: str) -> list[str]:
        """Return the robots of the package that name a file, those that name one of these, and so on."""
        found, waiting = {path}, [path]
        while waiting:
            inner = waiting.pop()
            more = [] if self.is_other_copy(inner) else self.robots_naming(inner)
            waiting += [each for each in more if each not in found]
            found.update(more)
        return sorted(found - {path})

    def robots_naming(self, path: str) -> list[str]:
        """Return the robots that name a file: by an include, or elsewhere in their texts."""
        if path not in self._robots_naming:
            self._robots_naming[path] = self.find_robots_naming(path)
        return self._robots_naming[path]

    @cached_property
    def _robots_naming(self) -> dict[str, list[str]]:
        return {}

    def find_robots_naming(self, path: str) -> list[str]:
        name = path.rpartition("/")[2]
        texts = dict(self.texts)
        named = (each for each in self.naming(path) if each.endswith(XACRO))
        return [
            each for each in named if not may_include(texts[each], name) or self.is_included(path, each, texts[each])
        ]

    def is_included(self, path: str, by: str, text: str) -> bool:
        """Return whether a robot of the package, of a text, may include a file of the package."""
        return includes_path(by, text, path, self.package.name, self.paths)

    @cached_property
    def paths(self) -> frozenset[str]:
        return frozenset(self.files.paths)

    def is_other_copy(self, path: str) -> bool:
        """Return whether texts name a file of this name with the folder of another copy, and none with this one's."""
        return self.with_folders.is_other_copy(path)

    @cached_property
    def with_folders(self) -> NamedWithFolder:
        return NamedWithFolder(self.paths, self.package.name, self.workspace, self.texts)

    @cached_property
    def elsewhere(self) -> NamedElsewhere:
        """What tells files of one name apart; imported where a robot is named at all."""
        from .named_elsewhere import NamedElsewhere

        return NamedElsewhere(self.paths, self.package, self.workspace)

    def is_surely_named(self, path: str) -> bool:
        """Return whether a text of the package names a file, or one of another that names the package as well.

        Another package that has a file of that name may mean its own, and so may each folder of one package.
        """
        name = path.rpartition("/")[2]
        words, having = {self.package.name, name.partition(".")[0]}, {self.package.name, *self.having(name)}
        if "/" in path and any(each != path and each.endswith(f"/{name}") for each in self.files.paths):
            return any("/".join(path.split("/")[-2:]) in text for other, text in self.texts if other != path)
        others = (facts for facts in self.workspace.packages if facts.name not in having)
        return self.is_named(path) or any(words <= each for facts in others for each in facts.robot_words)

    def is_named_in_full(self, path: str) -> bool:
        """Return whether a text of the package names a file with its suffix, and no file of the same name elsewhere."""
        name = re.compile(rf"{re.escape(path.rpartition('/')[2])}(?![\w.])")
        return not self.is_copy(path) and any(name.search(text) for other, text in self.texts if other != path)

    def is_put_together(self, path: str) -> bool:
        """Return whether a launch file of the package may put the name of a robot together when it runs."""
        return any(may_be_made(path.rpartition("/")[2], words) for words in self.launch_words)

    @cached_property
    def launch_words(self) -> tuple[frozenset[str], ...]:
        return tuple(words_of(text) for other, text in self.texts if other.endswith(LAUNCH))

    def is_copy(self, path: str) -> bool:
        """Return whether a file in the package's own folder is called like another of the package, deeper down."""
        return bool(self.deeper(path))

    def deeper(self, path: str) -> list[str]:
        """Return the folders with a file that is called like one in the package's own folder."""
        return [posixpath.dirname(each) for each in self.files.paths if "/" not in path and each.endswith(f"/{path}")]

    def is_named(self, path: str) -> bool:
        return any(True for _ in self.naming(path))

    def naming(self, path: str) -> Iterator[str]:
        """Yield the paths of the texts of the package that name a file."""
        name = path.rpartition("/")[2]
        word, full, is_copy = re.escape(name.partition(".")[0]), f"{re.escape(name)}{ENDS}", self.is_copy(path)
        before = r"(?<![\w./-])" if is_copy else ""  # what names the other has a folder before it
        ends = rf"(?:[\"']|\.{self.but_others(name)})"  # behind a slash it is a folder
        stem = re.compile(rf"[\"'{'' if is_copy else '/'}]{word}{ends}|{before}{full}")
        plain = re.compile(rf"{before}(?<![\w.-]){word}(?![\w-])|{before}{full}")
        typed = re.compile(rf"^(?=.*{COMMAND}).*{before}{full}", re.MULTILINE)
        deeper, first = self.deeper(path), name.partition(".")[0]
        for other, text in self.texts:
            if first not in text or other == path:
                continue
            how = plain if other.endswith((".yaml", ".yml")) else typed if other.endswith(PAGES) else stem
            in_full = other.endswith(ROBOTS) or not LETTERS.search(word) or not may_end(other, text, name)
            how = re.compile(before + full) if in_full else how
            is_beside = not is_copy or "/" not in other or not other.endswith(PAGES)
            is_beside = is_beside and not any(has_folders(each, text) for each in deeper)
            if is_beside and how.search(text):
                yield other

    def but_others(self, name: str) -> str:
        """Return a pattern that fits no suffix of another file of this stem: of `arm.urdf` beside `arm.sdf`."""
        stem = name.partition(".")[0]
        others = {each.rpartition("/")[2] for each in self.files.paths} - {name}
        ends = sorted(each.partition(".")[2] for each in others if each.partition(".")[0] == stem)
        return rf"(?!(?:{'|'.join(map(re.escape, ends))})(?![\w.]))" if ends else ""

    def is_named_elsewhere(self, path: str) -> bool:
        """Return whether a text of another package names a file and this package, or none that has such a file."""
        name, own = path.rpartition("/")[2], self.package.name
        stem = name.partition(".")[0]
        if self.workspace.named(stem) is not None:
            stem = name  # the word alone is a package
        for facts in self.workspace.packages:
            for words in facts.robot_words if facts.name != own else ():
                is_stem = stem in words and not self.names_another(words, name)
                if own in words and (is_stem or may_be_made(name, words)):
                    return True
                if is_stem and not any(other in words for other in self.having(name)):
                    return True
        return False

    def names_another(self, words: frozenset[str], name: str) -> bool:
        """Return whether words name another file of this stem, as `arm.urdf` beside `arm.sdf`, and not this one."""
        stem = name.partition(".")[0]
        others = {each.rpartition("/")[2] for each in self.files.paths} - {name}
        return name not in words and any(each in words for each in others if each.partition(".")[0] == stem)

    def having(self, name: str) -> list[str]:
        """Return the other packages that have a file of a name."""
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        return [
            each.name
            for each in others
            if any(p.rpartition("/")[2] == name for p in (*each.share_files, *each.uninstalled))
        ]

    def is_always_given(self, path: str, argument: str) -> bool:
        """Return whether each launch file that runs xacro and names a robot gives it an argument, and one does.

        One that names another file of the robot's name in full (`arm.urdf`, beside `arm.urdf.xacro`) opens that.
        """
        name = path.rpartition("/")[2]
        stem = re.compile(rf"\b{re.escape(name.partition('.')[0])}\b")
        given, key = (re.compile(each.format(re.escape(argument))) for each in (GIVES, KEY))
        names = [text for other, text in self.texts if other.endswith(LAUNCH) and "xacro" in text]
        naming = [text for text in names if stem.search(text) and not opens_a_twin(name, words_of(text))]
        gives = [bool(given.search(text) or ("mappings" in text and key.search(text))) for text in naming]
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        wanted = {self.package.name, name.partition(".")[0]}
        words = [each for facts in others for each in facts.robot_words if wanted <= each]
        gives += [argument in each for each in words if not opens_a_twin(name, each)]
        return bool(gives) and all(gives)

    @cached_property
    def texts(self) -> tuple[tuple[str, str], ...]:
        """The path and the text of each file that may open a robot."""
        return tuple(opening_texts(self.files, self.package, self.workspace))


def may_end(path: str, text: str, name: str) -> bool:
    """Return whether code may put a suffix behind the name of a robot, which may be a name in Gazebo as well."""
    return not path.endswith(".py") or LOOKS in text or may_be_made(name, words_of(text))


def has_folders(folder: str, text: str) -> bool:
    """Return whether all folders of a path stand in a text, joined or one by one; no suffix is one."""
    return all(re.search(rf"(?<![\w.]){re.escape(each)}(?![\w.])", text) for each in folder.split("/"))


def opens_a_twin(name: str, words: frozenset[str]) -> bool:
    """Return whether words have a file in full that is called like a robot but for the suffix, and not that itself."""
    start = f"{name.partition('.')[0]}."
    return name not in words and any(each.startswith(start) for each in words)
