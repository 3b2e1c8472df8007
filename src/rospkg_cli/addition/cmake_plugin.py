"""The target of a plugin, and the export of its description."""

from __future__ import annotations

from collections.abc import Iterator

from ..edits.cmake_commands import remove
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_facts import SEARCHES
from ..package.cmake.cmake_project import CMake
from ..package.package import Package
from ..scaffold.plugin import RequestedPlugin
from .cmake_block import block_removals
from .cmake_find import cmake_of
from .cmake_node import STANDARD, sets_standard
from .cmake_target import put_target
from .part import Operations

EXPORT = "pluginlib_export_plugin_description_file"


@dataclass(frozen=True)
class PluginTarget:
    plugin: RequestedPlugin
    package: str
    """The name of the package in package.xml."""

    def add(self, package: Package) -> Operations:
        """Return the block; raises ChangeError where the name is taken, NotUnderstoodError where no place is found."""
        cmake = cmake_of(package)
        return put_target(cmake, self.plugin.library, f"src/{self.plugin.name}.cpp", self.lines(cmake))

    def lines(self, cmake: CMake) -> str:
        """Return the commands, in lower case, without a blank line around them."""
        name = self.plugin.library
        automatic = bool(cmake.named(*SEARCHES))
        lines = [f"{'ament_auto_' if automatic else ''}add_library({name} SHARED src/{self.plugin.name}.cpp)"]
        if not automatic and not sets_standard(cmake):
            lines.append(f"target_compile_features({name} PRIVATE {STANDARD})")
        if not automatic:
            lines += [
                f"target_include_directories({name} PRIVATE ${{{each}_INCLUDE_DIRS}})"
                for each in self.plugin.header_packages
            ]
            linked = [base_target(cmake, self.plugin), *self.plugin.targets]
            targets = "".join(f"\n{cmake.root.indent}{each}" for each in linked if each)
            lines.append(f"target_link_libraries({name} PRIVATE{targets}\n)")
        if self.plugin.base:
            owner = self.package if self.plugin.is_own else self.plugin.exported_to
            lines.append(f"{EXPORT}({owner} {self.plugin.description})")
        else:
            lines.append(f"target_compile_definitions({name} PRIVATE BT_PLUGIN_EXPORT)")
        return "\n".join(lines)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the block as it was written, else that of the commands about the plugin."""
        cmake = cmake_of(package)
        if cmake.target(self.plugin.library) is None:
            return
        yield from block_removals(cmake.root, self.lines(cmake))
        mine = {self.plugin.library, self.plugin.description}
        about = [each for each in cmake.root.top if mine.intersection(word.text for word in each.arguments)]
        about = [each for each in about if each.name != "install"]
        if about:
            yield tuple(remove(cmake.root, each) for each in about)


def base_target(cmake: CMake, plugin: RequestedPlugin) -> str:
    """Return the library of headers that a package of ours has for the base class of its plugins; "" for none."""
    name = f"{plugin.package}_base"
    return name if plugin.is_own and cmake.target(name) is not None else ""
