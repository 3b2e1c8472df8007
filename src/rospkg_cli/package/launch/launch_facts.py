"""What other packages may know of the launch files of a package."""

from __future__ import annotations

from ...files import ReaderInput
from .configuration_events import ConfigurationSummary, summary
from .launch_file import LaunchFile


def started_nodes(reading: ReaderInput) -> frozenset[tuple[str, str]]:
    """Return package and executable of every node that a package's launch files start under literal names."""
    files = reading.parts(LaunchFile).good
    return frozenset(
        (package, executable.literal or "") for file in files for package, executable, _ in file.programs()
    )


def loaded_components(reading: ReaderInput) -> frozenset[tuple[str, str]]:
    """Return package and class of every component that a package's launch files load under literal names."""
    nodes = (node for file in reading.parts(LaunchFile).good if not file.is_ros1 for node in file.nodes)
    named = ((node.package, node.plugin) for node in nodes if node.kind == "composable_node")
    return frozenset(
        (package.literal, plugin.literal)
        for package, plugin in named
        if package and plugin and package.literal and plugin.literal
    )


def launch_summaries(reading: ReaderInput) -> tuple[ConfigurationSummary, ...]:
    """Return what other launch files may know of those of a package."""
    files = [file for file in reading.parts(LaunchFile).good if not file.is_ros1]
    return tuple(
        summary(file.path.rpartition("/")[2], file.events or (), file.is_complete and file.events is not None)
        for file in files
    )
