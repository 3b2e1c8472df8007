"""CMK004 after-ament-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.after_ament_package import ENDS, MisplacedCommand, commands_after_ament_package
from ...edits.cmake_commands import add_at_end, remove
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

HEAD = CMAKE.removesuffix("ament_package()\n")
MAX_RELATED = 10
EXPORT = "ament_export_include_directories(include/${PROJECT_NAME})\n"


@rule(
    "CMK004",
    "after-ament-package",
    over=CMakePackage,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "what comes too late are only the linters",
        Severity.INFO: "what is registered too late is registered in time as well, or nothing looks for it",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": f"{HEAD}ament_package()\n«{EXPORT.strip()}»\n"},
            good={"CMakeLists.txt": f"{HEAD}{EXPORT}\nament_package()\n"},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def after_ament_package(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds calls after `ament_package()` or `ament_auto_package()` that have to come before it.
    These are exports, generated interfaces, components, plugins, linters, and targets of `ament_auto_add_*`.

    ## Why is this bad?
    Some of them stop CMake. The others silently do nothing: the component is not registered, the linters don't run.

    ## When it is quiet
    For a plain `install()`, which does no harm there. In files that CMakeLists.txt includes, in functions, and under a
    condition that can't be evaluated. For linters where a macro such as `autoware_package()` has run them before.
    It is an info where the same call stands before `ament_package()` too, and for a description of plugins of
    `rclcpp_components`: containers find components by what `rclcpp_components_register_node()` registers.

    ## Fix safety
    The call of `ament_package()` goes to the end of the file, past everything that may be there on purpose.
    """
    found = list(commands_after_ament_package(package.cmake))
    late = [each for each in found if not each.unmissed]
    if not late:
        yield from map(superfluous, found[:1])
        return
    late.sort(key=lambda each: (each.only_linters, not each.is_fatal))
    first, *others = late
    end, more = first.end.name, f" and {len(others)} more come" if others else " comes"
    message = f"`{first.call.name}`{more} after `{end}()`: {first.consequence}; call `{end}()` last"
    place = Related(first.end.path, first.end.command.span, f"`{end}()` is called here")
    also = (Related(each.call.path, each.call.command.span, each.consequence) for each in others[:MAX_RELATED])
    level = Severity.WARNING if first.only_linters else None
    fix = move_to_end(package, first)
    yield Hit(first.call.path, first.call.command.span, message, level, (place, *also), fix)


def superfluous(late: MisplacedCommand) -> Hit:
    end = late.end.name
    place = Related(late.end.path, late.end.command.span, f"`{end}()` is called here")
    message = f"`{late.call.name}` comes after `{end}()`: it registers nothing, and {late.unmissed}; remove it"
    return Hit(late.call.path, late.call.command.span, message, Severity.INFO, (place,))


def move_to_end(package: CMakePackage, late: MisplacedCommand) -> Fix | None:
    """Return the fix, where the call is alone in its lines, outside of any block, and the only one that ends."""
    file = package.cmake.root
    command = late.end.command
    again = [call for call in package.cmake.named(*ENDS) if call is not late.end]
    taken = remove(file, command)
    if command not in file.body or taken.span == command.span or again:
        return None
    edits = (taken, add_at_end(file, file.source.slice(command.span)))
    return Fix(f"call `{late.end.name}()` at the end", edits, Safety.UNSAFE)
