"""CMK005 removed-command."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.cmake.ament_target_dependencies import AmentTargetDependencies
from ...checks.cmake.removed_command import RemovedCommand, Replacement
from ...edits.cmake_link import use_target_link_libraries
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...ros.distros import Targets
from ...rule import rule

BODY = "  <depend>rclcpp</depend>\n  <depend>std_msgs</depend>\n"
SOURCE = "int main() {return 0;}\n"
FOUND = "find_package(rclcpp REQUIRED)\nfind_package(std_msgs REQUIRED)\nadd_executable(talker src/talker.cpp)\n"
INSTALL = "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nament_package"
ONE = CMAKE.replace("ament_package", f"{FOUND}«ament_target_dependencies»(talker rclcpp std_msgs)\n{INSTALL}")
LIST = "set(dependencies rclcpp std_msgs)\n"
MANY = CMAKE.replace(
    "ament_package", f"{FOUND}{LIST}«ament_target_dependencies»(talker PUBLIC\n  ${{dependencies}}\n)\n{INSTALL}"
)
TARGETS = "  rclcpp::rclcpp\n  ${std_msgs_TARGETS}\n"
FILES = {"package.xml": manifest(BODY, "ament_cmake"), "src/talker.cpp": SOURCE}


@rule(
    "CMK005",
    "removed-command",
    over=AmentTargetDependencies,
    severity=Severity.INFO,
    levels={
        Severity.WARNING: "Kilted is a named target: it warns",
        Severity.ERROR: "Lyrical or a later one is a named target: it does not know the command",
    },
    examples=(
        Example(
            bad={**FILES, "CMakeLists.txt": ONE},
            good={
                "CMakeLists.txt": ONE.replace("«ament_target_dependencies»", "target_link_libraries").replace(
                    "talker rclcpp std_msgs", "talker PUBLIC rclcpp::rclcpp ${std_msgs_TARGETS}"
                )
            },
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={**FILES, "CMakeLists.txt": MANY},
            good={
                "CMakeLists.txt": MANY.replace("«ament_target_dependencies»", "target_link_libraries").replace(
                    "  ${dependencies}\n", TARGETS
                )
            },
            on="ament_cmake",
            fix=Safety.UNSAFE,
            targets=("lyrical",),
        ),
    ),
)
def removed_command(linked: AmentTargetDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds `ament_target_dependencies()`, which is deprecated in Kilted and removed in Lyrical.

    ## Why is this bad?
    The configuration stops with "Unknown CMake command". Linking targets (`rclcpp::rclcpp`, `${std_msgs_TARGETS}`)
    works on every supported distribution.

    ## When it is quiet
    Inside an `if` that tests for the distribution or for the command. All calls of a package are one finding.

    ## Fix safety
    The packages are replaced by the targets that are known to be theirs, a package of messages by its variable
    `${std_msgs_TARGETS}`. Whether an unknown package exports targets is unknown, so its call is left. The target is
    linked as it was: PUBLIC and INTERFACE stay, and where it is linked without a keyword elsewhere, there is none.

    ## References
    - https://docs.ros.org/en/rolling/Releases/Release-Kilted-Kaiju.html
    """
    found = [(removed, linked.replacement(removed)) for removed in linked.removed()]
    if not found:
        return
    (first, _), *others = found
    related = tuple(Related(each.file.path, each.command.name_span, "and this call") for each, _ in others)
    counted = f" ({len(found)} calls)" if others else ""
    message = (
        f"`ament_target_dependencies`{counted} is deprecated in Kilted and gone in Lyrical: CMake stops there; "
        f"{advice([replacement for _, replacement in found])}"
    )
    level = level_for(linked.targets)
    yield Hit(first.file.path, first.command.name_span, message, level, related=related, fix=fix(found))


def level_for(targets: Targets) -> Severity | None:
    if targets.named(lambda distro: distro.name in ("lyrical", "rolling")):
        return Severity.ERROR
    return Severity.WARNING if targets.named(lambda distro: distro.name == "kilted") else None


def advice(replacements: Sequence[Replacement | None]) -> str:
    known = [each for each in replacements if each is not None]
    if not known:
        return "link the packages' targets with `target_link_libraries` (which ones is not known here)"
    guessed = ", ".join(f"`{name}`" for name in dict.fromkeys(name for each in known for name in each.guessed))
    unknown = f" (whether {guessed} exports targets is not known here)" if guessed else ""
    return f"link the targets of its packages with `target_link_libraries`{unknown}"


def fix(found: Sequence[tuple[RemovedCommand, Replacement | None]]) -> Fix | None:
    edits = [edit for each, new in found if new is not None for edit in use_target_link_libraries(each, new)]
    parts = [part for _, new in found if new is not None for part in new.parts]
    texts = " ".join(dict.fromkeys(text for part in parts for text in part.texts or ())) or "nothing"
    return Fix(f"link `{texts}` with target_link_libraries", tuple(edits), Safety.UNSAFE) if edits else None
