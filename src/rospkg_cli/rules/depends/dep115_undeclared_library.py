"""DEP115 undeclared-library."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.bare_libraries import BareLibraries
from ...checks.depends.linked_libraries import LinkedLibraries
from ...checks.depends.name_source import is_unmet
from ...edits.brought_hits import BroughtUse, left_to_others
from ...edits.undeclared_dependency import advice, declaration
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

NODE = """\
add_executable(node src/node.cpp)
{lines}
install(TARGETS node DESTINATION lib/${{PROJECT_NAME}})
ament_package()"""
LINKS = "target_link_libraries(node «modbus»)"
FINDS = "find_library(GPIOD_LIBRARY «gpiod» REQUIRED)\ntarget_link_libraries(node ${GPIOD_LIBRARY})"
ASKS = "find_package(PkgConfig REQUIRED)\npkg_check_modules(USB REQUIRED IMPORTED_TARGET «libusb-1.0>=1.0.20»)"


def example(lines: str, key: str, more: str = "") -> Example:
    return Example(
        on="ament_cmake",
        bad={
            "CMakeLists.txt": CMAKE.replace("ament_package()", NODE.format(lines=lines)),
            "package.xml": manifest(more, "ament_cmake"),
            "src/node.cpp": "int main() {return 0;}\n",
        },
        good={"package.xml": manifest(f"{more}  <depend>{key}</depend>\n", "ament_cmake")},
        fix=Safety.SAFE,
    )


@rule(
    "DEP115",
    "undeclared-library",
    over=LinkedLibraries,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where a dependency, or what else CMake requires, brings it or may bring it, an unreleased "
        "repository declares it in another package or installs it by apt, package.xml has it in a comment or for older "
        "distributions alone, or a page says to install it by hand"
    },
    examples=(
        example(LINKS, "libmodbus-dev"),
        example(FINDS, "libgpiod-dev"),
        example(ASKS, "libusb-1.0-dev", "  <buildtool_depend>pkg-config</buildtool_depend>\n"),
    ),
)
def undeclared_library(libraries: LinkedLibraries) -> Iterator[Hit]:
    """
    ## What it does
    Finds libraries of the system that CMake links or looks for and that package.xml does not declare.
    These are the plain names in `target_link_libraries()`, those in `find_library()`, and the modules of
    `pkg_check_modules()`, as far as a rosdep key is known for them. A call without REQUIRED counts where a target is
    linked with what it finds. It finds keys without headers (`libusb-1.0` for `libusb-1.0-dev`), too, where
    the library is included or linked.

    ## Why is this bad?
    It builds where somebody installed the library by hand. On the build farm, and in a container made by `rosdep
    install`, the build stops: "cannot find -lmodbus", or "The following required packages were not found".

    ## When it is quiet
    What a declared dependency certainly installs, or another package or module of pkg-config that CMake requires
    (glib-2.0 comes with gstreamer-1.0), is one info, which names who brings it, and what may come with one is another,
    as is what another package of the repository declares, or a list or a script of it installs (apt alone), where
    nothing shows a release, and what a page says to install by hand, or CMake links from /usr/local or /opt. Targets
    and library files of the package are left alone, what CMake downloads or takes from a folder of its own
    (`link_directories()`, `HINTS`), calls under a condition, and libraries that DEP104 or DEP105 tell of.

    ## Fix safety
    The fix is unsafe where a comment of package.xml leaves the library out.

    ## References
    - REP-149, depend
    """
    declared = libraries.includes.declared
    brought: list[BroughtUse] = []
    for each in libraries.undeclared():
        key, kind = each.keys[0], "test_depend" if each.testing else "depend"
        if bringer := libraries.bringer(each):
            brought.append(BroughtUse(key, bringer, kind, each.path, each.span))
            continue
        message = (
            f"`{key}` is not declared, and CMake needs `{each.name}` of it: the build stops where nothing else "
            f"brings it; {advice(declared, kind, *each.keys)}"
        )
        by_hand = libraries.includes.by_hand.why(each.name, each.keys)
        level = Severity.INFO if by_hand or is_unmet(declared, key, each.keys) else None
        yield Hit(each.path, each.span, message + by_hand, level, fix=declaration(declared, kind, key))
    yield from left_to_others(declared, brought, "needed by CMake")
    for bare in BareLibraries(libraries).all():
        kind = "test_depend" if bare.testing else "build_depend"
        message = (
            f"`{bare.key}` has neither headers nor what the linker reads, and the build needs `{bare.what}`: where "
            f"nothing else brings it, it stops here; {advice(declared, kind, bare.wanted)}"
        )
        by_hand = libraries.includes.by_hand.why(bare.what, (bare.key, bare.wanted))
        level = Severity.INFO if bare.may_be_brought or by_hand or is_unmet(declared, bare.wanted) else None
        yield Hit(bare.path, bare.span, message + by_hand, level, fix=declaration(declared, kind, bare.wanted))
