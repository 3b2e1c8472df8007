"""The target of a node in C++, and what installs it."""

from __future__ import annotations

from collections.abc import Iterator

from ..edits.cmake_commands import remove
from ..edits.cmake_install import LIBEXEC, install_executable, install_library
from ..edits.cmake_rule_place import block
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_facts import SEARCHES
from ..package.cmake.cmake_project import CMake
from ..package.package import Package
from ..scaffold.cpp import targets_of
from ..scaffold.requested_node import RequestedNode
from .cmake_block import argument_removals, block_removals
from .cmake_find import cmake_of
from .cmake_target import put_target
from .part import Operations

AUTOMATIC = ("ament_auto_package", "autoware_ament_auto_package")
"""Commands that install all targets of ament_auto_add_*."""

STANDARD = "cxx_std_17"
"""What every distribution from Humble on can compile; a later one asks for more through rclcpp's own target."""


@dataclass(frozen=True)
class NodeTarget:
    node: RequestedNode
    namespace: str
    library: str
    """The package's own library of headers; "" where the node needs none."""

    @property
    def name(self) -> str:
        return f"{self.node.name}_component" if self.node.kind.name == "component" else self.node.name

    def add(self, package: Package) -> Operations:
        """Return the block; raises ChangeError where the name is taken, NotUnderstoodError where no place is found."""
        cmake = cmake_of(package)
        return put_target(cmake, self.name, f"src/{self.node.name}.cpp", self.lines(cmake))

    def lines(self, cmake: CMake) -> str:
        """Return the commands, in lower case, without a blank line around them."""
        is_component = self.node.kind.name == "component"
        automatic = "ament_auto_" if cmake.named(*SEARCHES) else ""
        kind, shared = ("library", " SHARED") if is_component else ("executable", "")
        lines = [f"{automatic}add_{kind}({self.name}{shared} src/{self.node.name}.cpp)"]
        if not self.library and not automatic and not sets_standard(cmake):
            lines.append(f"target_compile_features({self.name} PRIVATE {STANDARD})")
        if not automatic:
            linked = [self.library] if self.library else []
            targets = "".join(f"\n{cmake.root.indent}{each}" for each in [*linked, *targets_of(self.node)])
            lines.append(f"target_link_libraries({self.name} PRIVATE{targets}\n)")
        if is_component:
            # lib/ is everybody's: two packages may have a node of one name
            lines.append(
                f"set_target_properties({self.name} PROPERTIES OUTPUT_NAME ${{PROJECT_NAME}}_{self.node.name})"
            )
            plugin = f'PLUGIN "{self.namespace}::{self.node.class_name}"'
            indent = f"\n{cmake.root.indent}"
            executable = f"EXECUTABLE {self.node.name}"
            lines.append(f"rclcpp_components_register_node({self.name}{indent}{plugin}{indent}{executable})")
        return "\n".join(lines)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the block as it was written, else that of the commands about the target."""
        cmake = cmake_of(package)
        if cmake.target(self.name) is None:
            return
        yield from block_removals(cmake.root, self.lines(cmake))
        about = [each for each in cmake.root.top if each.arguments and each.arguments[0].text == self.name]
        if about:
            yield tuple(remove(cmake.root, each) for each in about)


def sets_standard(cmake: CMake) -> bool:
    """Return whether CMakeLists.txt chooses the C++ of all its targets."""
    words = [text for call in cmake.named("set", "add_compile_options") for text in call.texts]
    return any(text == "CMAKE_CXX_STANDARD" or text.startswith("-std=") for text in words)


@dataclass(frozen=True)
class TargetInstalled:
    """A target in the rule that installs its like, or in a rule of its own."""

    name: str

    def add(self, package: Package) -> Operations:
        """Return the edit, nothing where it is installed already, or will be without a word."""
        cmake = cmake_of(package)
        target = cmake.target(self.name)
        if target is None or any(word.text == self.name for rule in cmake.installs for word in rule.items):
            return ()
        if cmake.named(*AUTOMATIC) and target.call.name.startswith("ament_auto_"):
            return ()
        return (install_library(cmake, target) if target.is_library else install_executable(cmake, target),)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the removal of the rule where it installs nothing else, else of the name in it."""
        cmake = cmake_of(package)
        for rule in cmake.installs:
            mine = [word for word in rule.items if word.text == self.name]
            file = cmake.file(rule.call.path)
            if not mine or not file.is_top(rule.call.command):
                continue
            if len(rule.items) > 1:
                yield from argument_removals(file, mine[0].span)
                continue
            for lines in (block(file, "TARGETS", self.name, LIBEXEC), library_rule(file.indent, self.name)):
                yield from block_removals(file, lines)
            yield (remove(file, rule.call.command),)


def library_rule(indent: str, name: str) -> str:
    """Return the rule that installs a library as `edits.cmake_install` writes it."""
    places = ("ARCHIVE DESTINATION lib", "LIBRARY DESTINATION lib", "RUNTIME DESTINATION bin")
    return f"install(TARGETS {name}" + "".join(f"\n{indent}{place}" for place in places) + "\n)"
