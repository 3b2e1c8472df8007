"""Targets of released message packages that something is linked with, and that they do not export (CMK110)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.values import Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_facts import SEARCHES
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...ros.core_messages import CORE_MESSAGES
from ...ros.distros import Targets
from ...ros.link_targets import link_targets
from ..fault import Level
from ..repository.older_distribution import OlderDistribution
from .consumers import Consumers
from .mistyped_links import MistypedLinks

OF_ROS = regex(
    r"rcl\w*|rmw\w*|rcutils|rcpputils|tf2\w*|pluginlib|class_loader|image_transport|cv_bridge|message_filters|nav2_\w+|"
    r"\w+_interface|image_geometry|laser_geometry|diagnostic_updater|rosbag2_\w+|moveit_\w+|realtime_tools"
)
"""Packages whose libraries ROS alone brings, in a folder where no linker looks."""
FOLDERS = ("link_directories", "target_link_directories", "add_link_options", "target_link_options")
NEW = ("lyrical", "rolling")
"""The distributions in which rosidl exports one target for all of a package's interfaces."""


@dataclass(frozen=True, slots=True)
class MessageTarget:
    word: Word
    package: str
    """The released one; "" where the target is that of the package's own interfaces."""
    level: Level
    target: str = ""
    """What the package exports to be linked instead of its name."""

    @property
    def sentence(self) -> str:
        text, package = self.word.text, self.package
        if not package:
            why = f'`{text}` is what generates the interfaces and no library: CMake stops with "may not be linked"'
            return f"{why}; link what `rosidl_get_typesupport_target()` returns"
        if text == package and self.target:
            why = f"`{text}` is no target, and no linker looks for `-l{text}` where ROS has its libraries"
            return f"{why}: the build stops; link `{self.target}`"
        if text == package:
            why = f"`{package}` has no library of its name: the linker finds no `-l{package}`"
        else:
            why = f"`{package}` exports `{text}` from Lyrical on alone: before, CMake stops as the target was not found"
        return f"{why}; link `${{{package}_TARGETS}}`"


@dataclass(frozen=True)
class MessageTargets:
    links: MistypedLinks
    targets: Targets
    distribution: OlderDistribution
    consumers: Consumers

    def all(self) -> Iterator[MessageTarget]:
        """Yield each name at its first place; nothing where other files may make targets."""
        cmake = self.links.package.cmake
        if not cmake.is_complete or cmake.reads_unknown_files:
            return
        seen: set[str] = set()
        own = {each.target.text for each in cmake.interface_targets if each.target.is_known}
        for link in TargetLinks(cmake).all:
            is_sure = link.word.is_known and not (link.package or link.word.maybe or link.call.maybe)
            if is_sure and link.word.text in own - seen and (level := self.level_of_new()):
                seen.add(link.word.text)
                yield MessageTarget(link.word, "", level)
            package, colons, target = link.word.text.partition("::")
            if package in CORE_MESSAGES and target in ("", package) and self.is_sure(link):
                level = self.level_of_exported() if colons else "error"
                if level and link.word.text not in seen:
                    seen.add(link.word.text)
                    yield MessageTarget(link.word, package, level)
            if not colons and package not in seen and (near := self.exported_by(package)) and self.is_sure(link):
                seen.add(package)
                yield MessageTarget(link.word, package, "error", near)

    def exported_by(self, package: str) -> str:
        """Return the target that a package of ROS exports, where its library has no plain name; else ""."""
        cmake = self.links.package.cmake
        if not OF_ROS.fullmatch(package) or cmake.named(*FOLDERS):
            return ""
        known = link_targets(package)
        own = [each for each in known.targets if each.startswith(f"{package}::")]
        return own[0] if known.certain and own else ""

    def is_sure(self, link: TargetLink) -> bool:
        """Return whether CMake certainly links the released package by this word."""
        package = link.word.text.partition("::")[0]
        is_known = link.word.is_known and not link.package and not (link.word.maybe or link.call.maybe)
        is_own = link.word.text in self.links.own or self.links.workspace.named(package) is not None
        return is_known and package in self.found and not is_own

    @cached_property
    def found(self) -> frozenset[str]:
        """The packages that CMake certainly finds: DEP107 reports others."""
        cmake = self.links.package.cmake
        return self.links.found if cmake.named(*SEARCHES) else frozenset(each.name for each in cmake.packages)

    def level_of_exported(self) -> Level | None:
        """Return how bad a target of a released package is: None unless it is certainly for an older distribution."""
        if self.targets.names:
            return self.level_of_new()
        named = self.distribution.named
        return "warning" if named and named.isdisjoint(NEW) else None

    def level_of_new(self) -> Level | None:
        """Return how bad it is to link what new distributions alone export."""
        names = [distro.name for distro in self.targets]
        if all(name in NEW for name in names):
            return None
        return "error" if self.targets.named(lambda distro: distro.name not in NEW) else "warning"
