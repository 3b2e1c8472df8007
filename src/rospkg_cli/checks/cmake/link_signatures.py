"""Targets that some calls link with a keyword (PUBLIC, PRIVATE, INTERFACE) and others without, which CMake refuses."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.command_blocks import Block
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.syntax import CommandInvocation
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.workspace import Workspace
from ...ros.link_targets import link_targets
from .ament_target_dependencies import REMOVED
from .dead_branches import DeadBranches
from .link_keywords import KEYWORDS, LINK_KEYWORDS, LINK_PLAINLY
from .switched_off import SwitchedOff
from .unmade_targets import UnmadeTargets

AUTOMATIC = ("ament_auto_add_gtest", "ament_auto_add_library", "ament_auto_add_executable")
"""Commands that link what `ament_auto_find_build_dependencies` found."""
WITH_KEYWORD = ("pybind11_add_module", "python3_add_library", "nanobind_add_module")
LINKING = ("target_link_libraries", REMOVED, "rosidl_target_interfaces", *LINK_PLAINLY, *WITH_KEYWORD)
OLDER = frozenset(LINK_KEYWORDS) - {*KEYWORDS}
"""Keywords that CMake counts as none here."""

Path = tuple[tuple[int, int], ...]
"""The branches that a command is in: block, and number of the branch."""


@dataclass(frozen=True)
class SignedLink:
    target: str
    call: EvaluatedCommand
    has_keyword: bool


@dataclass(frozen=True)
class MixedLink:
    former: SignedLink
    link: SignedLink
    is_certain: bool
    """Whether both are run for everyone, and link the same way in every distribution."""
    unsought: str
    """A package that must be found for one of them, and that nothing looks for; else ""."""
    is_off: bool
    """Whether one of them is run only where somebody turns a switch on, and nothing here does so."""


@dataclass(frozen=True)
class LinkSignatures:
    package: CMakePackage
    workspace: Workspace

    def mixed(self) -> Iterator[MixedLink]:
        """Yield, once for a target, the first call that links it otherwise than one before."""
        former: dict[str, list[SignedLink]] = {}
        reported: set[str] = set()
        for link in self.links():
            before = former.setdefault(link.target, [])
            other = next((each for each in before if self.clash(each, link)), None)
            if other is not None and link.target not in reported:
                reported.add(link.target)
                perhaps = any(each.call.maybe or each.call.name in AUTOMATIC for each in (other, link))
                unsought = (self.dead.package_of(each.call) for each in (other, link))
                is_off = any(self.off.has(each.call) for each in (other, link))
                yield MixedLink(other, link, not perhaps, next(filter(None, unsought), ""), is_off)
            before.append(link)

    def clash(self, one: SignedLink, other: SignedLink) -> bool:
        """Return whether two links differ, and nothing keeps the second from being run where the first one is."""
        if one.has_keyword == other.has_keyword:
            return False
        if not (one.call.maybe and other.call.maybe):
            return True
        first, second = (self.branches.get(id(each.call.command), ((0, 0),)) for each in (one, other))
        shorter = min(len(first), len(second))
        return not one.call.function and not other.call.function and first[:shorter] == second[:shorter]

    def links(self) -> Iterator[SignedLink]:
        unmade = UnmadeTargets(self.package.cmake)
        for call in self.package.cmake.named(*LINKING):
            word = call.first
            if word is not None and word.is_known and not word.maybe and not unmade.silence(call):
                has_keyword = self.has_keyword(call)
                if has_keyword is not None:
                    yield SignedLink(word.text, call, has_keyword)

    def has_keyword(self, call: EvaluatedCommand) -> bool | None:
        """Return whether a call links its target with a keyword; None where it may link nothing."""
        items = [word for word in call.words[1:] if word.text != "SYSTEM"]
        named = [word.text for word in items if word.text not in LINK_KEYWORDS and word.is_known and not word.maybe]
        if call.name in WITH_KEYWORD:
            return True
        if call.name in AUTOMATIC:
            return False if self.links_automatically and "INTERFACE" not in call.texts else None
        if call.name in (*LINK_PLAINLY, "rosidl_target_interfaces"):
            return False
        if not named or not items[0].is_known or items[0].maybe:
            return None
        if call.name == REMOVED and not any(map(self.has_targets, named)):
            return None
        return items[0].text in KEYWORDS if not OLDER & set(call.texts) else None

    @cached_property
    def dead(self) -> DeadBranches:
        return DeadBranches(self.package.cmake)

    @cached_property
    def off(self) -> SwitchedOff:
        return SwitchedOff(self.package.cmake)

    @cached_property
    def links_automatically(self) -> bool:
        needed = (each for each in self.package.manifest.dependencies if each.tag in ("depend", "build_depend"))
        finds = self.package.cmake.named("ament_auto_find_build_dependencies")
        return bool(finds) and any(self.has_targets(each.name) for each in needed)

    @cached_property
    def branches(self) -> dict[int, Path]:
        """The branches that each command of the package is in."""
        found: dict[int, Path] = {}
        waiting: list[tuple[CommandInvocation | Block, Path]]
        waiting = [(each, ()) for file in self.package.cmake.files for each in file.body]
        while waiting:
            each, path = waiting.pop()
            if isinstance(each, CommandInvocation):
                found[id(each)] = path
                continue
            for at, branch in enumerate(each.branches):
                waiting += [(below, (*path, (id(each), at))) for below in branch.body]
        return found

    def has_targets(self, package: str) -> bool:
        """Return whether a package certainly exports targets, which ament_target_dependencies then links."""
        facts = self.workspace.named(package)
        if facts is not None and facts.name != self.package.facts.name and facts.knows("cmake_targets"):
            return bool(facts.cmake_targets)
        found = link_targets(package)
        return found.certain and bool(found.targets)
