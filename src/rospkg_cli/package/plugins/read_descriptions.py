"""Find the plugin descriptions of a package: the files that it exports as such."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles, ReaderInput
from ...languages.cmake.evaluated_command import path_in_package
from ...languages.xml.parser import read_xml
from ...source import Span
from ...unreadable import Unreadable, UnreadableError
from ..cmake.cmake_project import CMake
from ..manifest import Manifest
from .description import DescriptionExport, PluginDescription

PREFIX = "${prefix}/"
EXPORT = "pluginlib_export_plugin_description_file"


def read_plugin_descriptions(reading: ReaderInput) -> Iterator[PluginDescription | Unreadable]:
    """Yield every description that is there, once, with all places that export it.

    A file that is not exported counts where it looks like one; it is skipped where it can't be read.
    """
    found: dict[str, list[DescriptionExport]] = {}
    for path, exported in (*by_cmake(reading), *by_manifest(reading)):
        if reading.files.exists(path):
            found.setdefault(path, []).append(exported)
    for path in reading.files.paths:
        if path.endswith(".xml") and path not in found and is_like_one(reading.files, path):
            found[path] = []
    for path, exports in found.items():
        try:
            document = read_xml(reading.files.source(path), takes_less_than=True)
            yield PluginDescription(document, tuple(exports))
        except UnreadableError as error:
            if exports:
                yield error.unreadable


def is_like_one(files: PackageFiles, path: str) -> bool:
    text = files.readable_text(path)
    return "base_class_type" in text and "<library" in text


def by_cmake(reading: ReaderInput) -> Iterator[tuple[str, DescriptionExport]]:
    for cmake in reading.parts(CMake).good:
        for call in cmake.named(EXPORT):
            if len(call.words) > 1 and call.words[0].is_known and call.words[1].is_known:
                base, file = call.words[:2]
                path = path_in_package(file.text, call.folder)
                if path:
                    exported = DescriptionExport(base.text, base.span, call.path, file.span, True, call.testing)
                    yield path, exported


def by_manifest(reading: ReaderInput) -> Iterator[tuple[str, DescriptionExport]]:
    for manifest in reading.parts(Manifest).good:
        for element in manifest.exports:
            plugin = element.attributes.get("plugin")
            if plugin is not None and plugin.value.startswith(PREFIX):
                tag = Span(element.open.start + 1, element.open.start + 1 + len(element.tag))
                exported = DescriptionExport(element.tag, tag, manifest.path, plugin.value_span, False)
                yield posixpath.normpath(plugin.value[len(PREFIX) :]), exported
