"""CMK111 absolute-destination."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import CMAKE, Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...languages.cmake.values import PREFIX, UNKNOWN, Word
from ...lazy_regex import regex
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.install_destinations import plain_root
from ...package.cmake.install_rule import InstallRule
from ...rule import rule

SLASH = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION «/share/${PROJECT_NAME}»)\nament_package")
HOME = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION «/home/ada/models»)\nament_package")
URDF = '<robot name="my_robot">\n  <link name="base_link"/>\n</robot>\n'

OUTSIDE = regex(r"/|~|\$ENV\{HOME\}")
SYSTEM = regex(r"/(?:etc|lib/udev|(?:usr/)?lib/systemd|usr/lib/udev)(?:/|$)")
STANDARD = regex(r"(?:.*/install(?:/[^/]+)?)?/((?:share|lib|include|bin)/.*)")
"""A folder below the prefix, with a slash or the path of a workspace before it."""
OF_SOMEBODY = regex(r"/home/|/Users/|~")
"""What only one machine has; other folders are there for whoever builds as root, as in a container."""
SLASH_TOO_MANY = regex(r"/(?:share|lib)/\$\{PROJECT_NAME\}(?:/|$)")
"""What is intended nowhere, whatever the condition around it."""


@rule(
    "CMK111",
    "absolute-destination",
    over=CMakePackage,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the folder is one of the system, where root may write, or in `$ENV{HOME}`, or a condition "
        "is around it"
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": SLASH, "urdf/robot.urdf": URDF},
            good={"CMakeLists.txt": SLASH.replace("«/share/${PROJECT_NAME}»", "share/${PROJECT_NAME}")},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={"CMakeLists.txt": HOME, "urdf/robot.urdf": URDF},
            good={"CMakeLists.txt": HOME.replace("«/home/ada/models»", "share/${PROJECT_NAME}")},
            on="ament_cmake",
        ),
    ),
)
def absolute_destination(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds `install(… DESTINATION …)` with an absolute path.
    It is a home folder, a system folder, or only has a slash too many.

    ## Why is this bad?
    The files don't go to colcon's install folder: the build fails for lack of permission, or it writes into a folder
    that exists only on one machine. No Debian package can be made of it.

    ## When it is quiet
    For what begins with a variable (`${CMAKE_INSTALL_PREFIX}/share`), also behind a slash where the variable holds the
    prefix or is unknown. Under a condition that can't be evaluated only `/share/${PROJECT_NAME}` and
    `/lib/${PROJECT_NAME}` are reported, as warnings.
    Rules of udev and units of systemd may belong in the system's folders: a warning. So are all its other folders
    (`/opt/tools`), where the build may write as root, and `$ENV{HOME}`, the home of whoever builds.
    """
    seen = set()
    for install in package.cmake.installs:
        word = install.destination_word
        if word is None or (word.path, word.span) in seen:
            continue
        raw = package.cmake.source_text(word).strip('"')
        if install.call.maybe and not SLASH_TOO_MANY.match(raw):
            continue
        if OUTSIDE.match(raw) and not may_be_prefix(word.text) and install.call.name != "ament_python_install_package":
            seen.add((word.path, word.span))
            if SYSTEM.match(raw):
                message = (
                    f"`DESTINATION {raw}` is a folder of the system: the build needs root, and no Debian package holds "
                    f"the file; install it into `{wanted(raw, install)}`"
                )
                yield Hit(word.path, word.span, message, Severity.WARNING)
                continue
            message = (
                f"`DESTINATION {raw}` is absolute: the files don't go to the install prefix, where ROS looks; write "
                f"`{wanted(raw, install)}`"
            )
            is_sure = STANDARD.fullmatch(raw) or OF_SOMEBODY.match(raw)
            is_mild = install.call.maybe or not is_sure
            level = Severity.WARNING if is_mild else None
            yield Hit(word.path, word.span, message, level, fix=fix(package, word, raw))


def may_be_prefix(text: str) -> bool:
    """Return whether an evaluated path is below the install prefix, or begins with something unknown."""
    return plain_root(text).startswith((PREFIX, f"/{UNKNOWN}"))


def wanted(raw: str, install: InstallRule) -> str:
    if found := STANDARD.fullmatch(raw):
        return found.group(1)
    return "lib/${PROJECT_NAME}" if install.kind in ("TARGETS", "PROGRAMS") else "share/${PROJECT_NAME}"


def fix(package: CMakePackage, word: Word, raw: str) -> Fix | None:
    found = STANDARD.fullmatch(raw)
    if found is None:
        return None
    quote = '"' if package.cmake.source_text(word).startswith('"') else ""
    edit = Edit(word.path, word.span, f"{quote}{found.group(1)}{quote}")
    return Fix(f"install into `{found.group(1)}` below the prefix", (edit,))
