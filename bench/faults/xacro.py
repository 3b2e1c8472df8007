"""Faults of macros, properties and arguments in xacro."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.comments import without_comments
from bench.faults.fault import PutFault
from bench.faults.source_package import SourcePackage
from bench.faults.urdf import NOT_HERE, has_all_included, own, urdf_kind


@urdf_kind
def urdf_mistyped_child_with_prefix(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<child\s+link\s*=\s*\"\$\{\w+\}(\w+)\""):
        if re.search(rf"<link\s+name\s*=\s*\"\$\{{\w+\}}{spot.word}\"", spot.text):
            yield spot.typo()


@urdf_kind
def urdf_prefix_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<child\s+link\s*=\s*\"(\$\{\w+\})(\w+)\""):
        if re.search(rf"<link\s+name\s*=\s*\"\$\{{\w+\}}{spot[2]}\"", spot.text):
            yield spot.put("", spot[2])


@urdf_kind
def urdf_mistyped_find(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"\$\(find (\w+)\)"):
        name = re.escape(spot.path.rpartition("/")[2])
        is_read = spot.path.endswith(".xacro") or "xacro:" in spot.text or package.holds(r"\.(py|xml|launch)$", name)
        yield spot.typo().known(is_read, "nothing replaces `$(find …)` in a plain robot that is not given to xacro")


@urdf_kind
def urdf_mistyped_include(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<xacro:include\s+filename\s*=\s*\"[^\"]*?([\w.-]+\.xacro)\""):
        if package.matching(rf"(^|/){re.escape(spot.word)}$"):
            yield spot.typo()


@urdf_kind
def urdf_mistyped_macro(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(
        package,
        r"<(xacro:(?!include|macro|property|arg|if|unless|insert_block|element|attribute|call)(\w+))(?=[\s/>])[^>]*/>",
    ):
        wrong = spot[2][:-1]
        made = rf"<xacro:macro\s+name\s*=\s*\"(?:xacro:)?{spot[2]}\""
        is_near = has_all_included(package, spot) or re.search(made, spot.text) is not None
        is_here = is_near and package.holds(r"\.(urdf|xacro)$", made)
        fault = spot.put(f"xacro:{wrong}", wrong, spot[2])
        yield fault.known(is_here, "the macros of a file that is included and not here")


@urdf_kind
def urdf_mistyped_property(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"\$\{([A-Za-z]\w{3,})\}"):
        if re.search(rf"<xacro:property\s+name\s*=\s*\"{spot.word}\"", spot.text):
            yield spot.typo()


@urdf_kind
def urdf_property_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"^\s*<xacro:property\s+name\s*=\s*\"(\w{2,})\"\s+value=[^>]*/>[ \t]*\n"):
        is_only = len(re.findall(rf"xacro:property\s+name\s*=\s*\"{spot.word}\"", spot.text)) == 1
        if is_only and re.search(rf"\$\{{[^}}]*\b{spot.word}\b", spot.text):
            yield spot.drop().known(has_all_included(package, spot), NOT_HERE)


@urdf_kind
def urdf_mistyped_macro_parameter(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<xacro:(\w+)\s+(\w+)\s*=\s*\"[^\"]*\"[^>]*/>", 2):
        found = re.search(rf"<xacro:macro\s+name\s*=\s*\"{spot[1]}\"\s+params\s*=\s*\"([^\"]*)\"", spot.text)
        if found and spot.word in re.split(r"[\s:=]+", found[1]):
            yield spot.typo()


@urdf_kind
def urdf_macro_argument_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<xacro:(\w+)\s+((\w+)\s*=\s*\"[^\"]*\")[^>]*/>", 2):
        found = re.search(rf"<xacro:macro\s+name\s*=\s*\"{spot[1]}\"\s+params\s*=\s*\"([^\"]*)\"", spot.text)
        if found and spot[3] in found[1].split():
            yield spot.put("", spot[3], spot[1])


@urdf_kind
def urdf_mistyped_argument(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"\$\(arg (\w+)\)"):
        if re.search(rf"<xacro:arg\s+name\s*=\s*\"{spot.word}\"", spot.text):
            yield spot.typo()


@urdf_kind
def urdf_brace_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"=\s*\"\$\{([\w.*/ +-]+)(\})\"", 2):
        yield spot.put("", spot[1], spot.path.rpartition("/")[2])


@urdf_kind
def urdf_namespace_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<robot\b[^>]*?(\s+xmlns:xacro\s*=\s*\"[^\"]+\")"):
        if "<xacro:" in without_comments(spot.path, spot.text):
            yield spot.put("", "xacro", spot.path.rpartition("/")[2])
