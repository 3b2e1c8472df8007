"""Plugin descriptions: XML files that list for pluginlib which class is in which library.

pluginlib (class_loader_imp.hpp) reads `<library path>` elements, alone or below `<class_libraries>`, and their
`<class type base_class_type name>`; where there is no name, the type is the name. It finds the files by the resource
`<package>__pluginlib__plugin` of the ament index, which pluginlib_export_plugin_description_file writes;
`<export><package plugin="${prefix}/file.xml"/></export>` of package.xml is what rqt_gui goes by.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.xml.parser import Attribute, Document, Element
from ...light_dataclasses import dataclass
from ...ros.plugins import RQT
from ...source import Source, Span


@dataclass(frozen=True, slots=True)
class DescriptionExport:
    """Where a file is exported, and to which package."""

    base: str
    """The package that loads the plugins."""
    base_span: Span
    path: str
    """CMakeLists.txt, or package.xml."""
    span: Span
    """Of the name of the file."""
    is_indexed: bool
    """By CMake, so that pluginlib finds it."""
    testing: bool = False
    """Only where tests are built."""


@dataclass(frozen=True, slots=True)
class PluginClass:
    type: Attribute
    base: Attribute
    name: Attribute | None
    library: Element
    element: Element

    @property
    def lookup_name(self) -> str:
        """The name by which it is loaded."""
        return self.name.value if self.name is not None else self.type.value

    @property
    def names(self) -> frozenset[str]:
        """What may mean it: the name by which it is loaded, and its class."""
        return frozenset((self.lookup_name, self.type.value))

    @property
    def is_python(self) -> bool:
        """Whether it is loaded by a loader for Python (rqt_gui_py and qt_gui_py name no C++ class)."""
        return "_py::" in self.base.value or ("::" not in self.type.value and "." in self.type.value)

    @property
    def path(self) -> Attribute | None:
        """The library, as it is written."""
        return self.library.attributes.get("path")


@dataclass(frozen=True)
class PluginDescription:
    document: Document
    exported: tuple[DescriptionExport, ...]

    @property
    def source(self) -> Source:
        return self.document.source

    @property
    def file(self) -> str:
        """The path of the file."""
        return self.document.source.path

    @property
    def libraries(self) -> Iterator[Element]:
        root = self.document.root
        if root.tag == "library":
            yield root
        elif root.tag == "class_libraries":
            yield from (child for child in root.children if child.tag == "library")

    @cached_property
    def classes(self) -> tuple[PluginClass, ...]:
        """The classes that have what pluginlib wants of them."""
        return tuple(self._classes())

    def _classes(self) -> Iterator[PluginClass]:
        for library in self.libraries:
            for child in library.children:
                kind, base = child.attributes.get("type"), child.attributes.get("base_class_type")
                if child.tag == "class" and kind is not None and base is not None:
                    yield PluginClass(kind, base, child.attributes.get("name"), library, child)

    @property
    def is_indexed(self) -> bool:
        """Whether pluginlib finds it."""
        return any(each.is_indexed for each in self.exported)

    @property
    def is_for_rqt(self) -> bool:
        """Whether package.xml exports it to rqt."""
        return any(not each.is_indexed and each.base in RQT for each in self.exported)

    @property
    def bases(self) -> frozenset[str]:
        """The packages that it is exported to."""
        return frozenset(each.base for each in self.exported)
