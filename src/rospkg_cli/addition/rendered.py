"""Files of our templates for a package that exists: with its name, its license and its maintainer."""

from __future__ import annotations

import datetime
import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from ..light_dataclasses import dataclass, replace
from ..package.manifest import Manifest
from ..ros.distros import NEWEST_LTS, distro
from ..ros.licenses import LICENSES, offered, spdx_id
from ..scaffold.answers import Answers
from ..scaffold.bringup import Bringup
from ..scaffold.maintainer import CODING, LONGEST
from ..scaffold.render import RenderedFile, render
from ..scaffold.template import Template, TemplateFile
from ..scaffold.user_text import UserText, user_text
from .new_file import without_header

NOTHING: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True)
class Author:
    """Who a new file says that it is of, and under which license."""

    name: UserText
    spdx: str
    """"" where the license is none whose header is known: then there is no header."""


def author_of(manifest: Manifest) -> Author:
    """Return the first maintainer, and the license where there is one and its header is known."""
    maintainer = " ".join(manifest.text("maintainer").split())[:LONGEST] or "the authors"
    licenses = manifest.all("license")
    spdx = spdx_id(licenses[0].text) if len(licenses) == 1 else None
    known = offered(spdx) if spdx else None
    printable = "".join(char for char in maintainer if char.isprintable())
    plain = "the authors" if CODING.search(printable) else printable  # Python would read it as that of the file
    return Author(user_text("the maintainer's name", plain), known.spdx if known else "")


def rendered_files(
    template: Template,
    files: tuple[TemplateFile, ...],
    manifest: Manifest,
    name: str,
    more: Mapping[str, str] = NOTHING,
    **answers: Any,
) -> tuple[RenderedFile, ...]:
    """Return some files of a template; `answers` are the fields of Answers that matter to them.

    `name` is what the code calls the package: that of its Python module or of its namespace; `more` is what the files
    know besides the answers.
    """
    author = author_of(manifest)
    known = offered(author.spdx) or LICENSES[0]
    defaults: dict[str, Any] = {
        "nodes": (),
        "started": Bringup(),
        "interfaces": (),
        "depends": (),
        "test_depends": (),
        "description": UserText(""),
        "license": known,
        "maintainer": author.name,
        "email": "",
        "version": "0.0.0",
        "distro": distro(NEWEST_LTS),
        "year": datetime.date.today().year,
        "launch": "",
        "params": False,
        "tests": "none",
        "plugins": (),
    }
    found = render(replace(template, files=files), Answers(name=name, **{**defaults, **answers}), more)
    return found if author.spdx else tuple(map(headless, found))


def headless(file: RenderedFile) -> RenderedFile:
    """Return a file without a header, for a license that has none we know."""
    if not file.path.endswith((".py", ".cpp", ".hpp")) and not file.entry.is_executable:
        return file
    data = without_header(file.entry.text.text).encode()
    return RenderedFile(file.path, replace(file.entry, data=data), file.about)


def identifier(name: str) -> str:
    """Return a package's name as one of Python and C++: the schemas allow hyphens in it."""
    return re.sub(r"\W", "_", name)
