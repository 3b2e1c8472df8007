"""RPK001 unreadable-file."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.read_sentences import what_is_wrong
from ...checks.unreadable_files import UnreadableFile
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...rule import rule

BAD = """\
<package format="3">
  <name>my_pkg</name>
</«p»ackages>
"""
GOOD = """\
<package format="3">
  <name>my_pkg</name>
</package>
"""
BAD_CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
«find_package(»ament_cmake REQUIRED
ament_package()
"""


@rule(
    "RPK001",
    "unreadable-file",
    over=UnreadableFile,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a robot that urdfdom reads all the same; a launch file for ROS 1 in a package for both; a "
        "module of Python that another package imports",
        Severity.INFO: "a robot, a world, a behavior tree, a launch file or YAML that nothing is shown to open, a "
        "launch file for ROS 1, a module of Python that nothing imports that is started, bytes that are no text in "
        "comments of CMake, a line of Python with a blank to fill in, or plugins without a root around them",
    },
    examples=(
        Example(bad={"package.xml": BAD}, good={"package.xml": GOOD}),
        Example(bad={"CMakeLists.txt": BAD_CMAKE}, good={"CMakeLists.txt": CMAKE}, on="ament_cmake"),
    ),
)
def unreadable_file(scope: UnreadableFile) -> Iterator[Hit]:
    """
    ## What it does
    Reports a file that is needed and can't be read.
    It is XML that is not well-formed, CMake, Python or YAML with a syntax error, or bytes that are no text, in a file
    that the build, an installed file or `colcon test` reads. What Python parses and does not compile is a syntax error,
    too: a keyword given twice in a call, `return` outside of a function. There is one finding for a file, at the exact
    place; rules that need the file are skipped until it is fixed.

    ## Why is this bad?
    colcon does not stop at a broken package.xml: it takes the folder for a plain Python or CMake package, without a
    warning, and `ros2 run` doesn't find it.

    ## When it is quiet
    Files that neither the build, nor an installed file, nor a test by its name reads may be broken. A file of
    interfaces is reported by its own rules, a file that is too large by RPK007. In worlds and SDF only tags that don't
    match are reported, as Gazebo reads past the rest; in behavior trees also those that are not closed.

    A robot, a world or a behavior tree is an info where nothing is shown to open it: a launch file, code or a typed
    command that names it with its place (Gazebo has an `empty.sdf` of its own), or YAML by a key that is read; the
    default of an argument that nothing reads opens nothing. It is a warning where urdfdom reads past the fault: an
    undeclared prefix, or something behind the root element, in a plain `.urdf`. A Python module is an info where no
    entry point, launch file or CMake file names it, nor a module that one of these names, a warning where another
    package imports it. A launch file for ROS 1 is an info, in a package for catkin as well a warning. A launch file
    next to others is an info where no other file of the package, no page or script, and no package that needs this one
    names it, and so is YAML that no command of a page and no code names. Several `<library>` of a plugin description
    without a root are an info, and so are bytes that are not UTF-8 in comments of a CMake file, and a line of Python
    with a blank that an exercise has people fill in (`create_timer(???)`, `<MESSAGE_TYPE>`). A `<` in the value of
    an attribute of a plugin description is no fault, since pluginlib takes it.
    """
    file = scope.file
    if not (file.grammar or file.skipped):
        level, why = scope.level()
        yield Hit(file.path, file.span, what_is_wrong(file) + why, Severity(level) if level else None)
