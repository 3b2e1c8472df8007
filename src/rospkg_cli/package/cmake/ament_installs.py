"""What the commands of ament, pluginlib and catkin install."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Iterable, Iterator, Mapping

from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values
from ...languages.cmake.values import Word
from ..install_table import PYTHON
from .install_destinations import below_prefix
from .install_keywords import PACKAGE_KEYWORDS
from .install_rule import InstallRule, Pattern
from .install_rules import files_rule, rules_of_install

FLAGS_OF_AUTO = ("INSTALL_TO_PATH", "USE_SCOPED_HEADER_INSTALL_DIR")
"""What is no folder wherever it stands among the arguments of `ament_auto_package`; the second since Humble 1.3.12."""


def auto_package(project: str) -> Callable[[EvaluatedCommand], Iterator[InstallRule]]:
    """`ament_auto_package(INSTALL_TO_SHARE …)`: folders are installed in share/, under their own names."""

    def make(call: EvaluatedCommand) -> Iterator[InstallRule]:
        _, values, _ = flags_and_values(call.words, FLAGS_OF_AUTO, (), ("INSTALL_TO_SHARE",))
        if folders := values.get("INSTALL_TO_SHARE"):
            yield InstallRule("DIRECTORY", tuple(folders), f"share/{project}", call)

    return make


def python_package(call: EvaluatedCommand) -> Iterator[InstallRule]:
    """`ament_python_install_package(name)`: a folder is installed in site-packages."""
    _, values, rest = flags_and_values(call.words, ("SKIP_COMPILE",), PACKAGE_KEYWORDS, ())
    for name in rest[:1]:
        folder = next(iter(values.get("PACKAGE_DIR", [])), name)
        place = below_prefix(values["DESTINATION"][0].text) if values.get("DESTINATION") else PYTHON
        target = None if place is None or not name.is_known else posixpath.join(place, name.text)
        inside = Word(folder.text.rstrip("/") + "/", folder.path, folder.span, folder.maybe)
        skip = (Pattern("*.pyc", False, True), Pattern("__pycache__", False, True))
        yield InstallRule("DIRECTORY", (inside,), target, call, name, patterns=skip)


def python_module(call: EvaluatedCommand) -> Iterator[InstallRule]:
    """`ament_python_install_module(file.py)`"""
    _, values, rest = flags_and_values(call.words, ("SKIP_COMPILE",), ("DESTINATION_SUFFIX",), ())
    suffix = "".join(word.text for word in values.get("DESTINATION_SUFFIX", []))
    place = below_prefix(posixpath.join(PYTHON, suffix))
    yield InstallRule("FILES", tuple(rest[:1]), place, call)


def plugin_description(project: str) -> Callable[[EvaluatedCommand], Iterator[InstallRule]]:
    """`pluginlib_export_plugin_description_file(base folder/file.xml)`: to share/, with its folder."""

    def make(call: EvaluatedCommand) -> Iterator[InstallRule]:
        for word in call.words[1:2]:
            place = below_prefix(posixpath.join("share", project, posixpath.dirname(word.text)))
            yield InstallRule("FILES", (word,), place, call)

    return make


def catkin_style(call: EvaluatedCommand) -> Iterator[InstallRule]:
    """`catkin_install_python(PROGRAMS … DESTINATION …)`"""
    yield files_rule(call, "PROGRAMS", call.words[1:])


def install_rules(calls: Iterable[EvaluatedCommand], project: str) -> Iterator[InstallRule]:
    """Yield every rule, in order."""
    makers: Mapping[str, Callable[[EvaluatedCommand], Iterator[InstallRule]]] = {
        "install": rules_of_install,
        "catkin_install_python": catkin_style,
        "ament_auto_package": auto_package(project),
        "autoware_ament_auto_package": auto_package(project),
        "ament_python_install_package": python_package,
        "ament_python_install_module": python_module,
        "pluginlib_export_plugin_description_file": plugin_description(project),
    }
    for call in calls:
        if maker := makers.get(call.name):
            yield from maker(call)
