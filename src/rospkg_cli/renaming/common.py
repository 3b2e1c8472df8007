"""How a package is named in files of any kind: `package://`, `$(find …)`, paths of an installation, commands."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..source import Span
from .patterns import found
from .renamed_package import RenamedPackage

OF_CMAKE = (
    r"(?:TARGETS|INCLUDE_DIRS?|LIBRAR(?:Y|IES)|LIBRARY_DIRS|LIB_DIRS|DEFINITIONS|DIR|FOUND|VERSION(?:_\w+)?"
    r"|SOURCE_DIR|BINARY_DIR|CONFIG|PACKAGE_NAME|LINK_FLAGS|RECURSIVE_DEPENDENCIES|INTERFACES|IDL_FILES)"
)
"""What the variables are called behind the name that `find_package` and `project` set."""

SHARED = (
    r"\bpackage://%NAME%(?=/|\W|$)",
    r"""\$\((?:find|find-pkg-share|find-pkg-prefix)\s+["']?%NAME%["']?\s*\)""",
    r"\$\(exec-in-pkg\s+\S+\s+%NAME%\s*\)",
    r"(?<![\w.-])(?:share|lib)/%NAME%",
    r"\bros2\s+(?:run|launch|pkg\s+\w+|interface\s+package)\s+(?:-\S+\s+)*%NAME%",
    r"\b\w*(?:pkg|package)(?:_name)?:?=%NAME%",
    r"--packages-[\w-]+(?:[\s\\]+\w[\w-]*)*?[\s\\]+%NAME%",
    rf"@%PART%_(?={OF_CMAKE}@)",
)
OF_INTERFACES = (
    r"(?<![\w/.-])%PART%(?=/(?:msg|srv|action)/)",
    r"(?<![\w:])%PART%(?=::(?:msg|srv|action)\b)",
    r"(?<!\w)%PART%(?=__(?:msg|srv|action)__)",
    r"""\b[A-Z][A-Z0-9_]{2,}\s*\((?:[^;{}()"]|"[^"\n]*")*?%NAME%(?=\s*[,)])""",
)
OF_LIBRARY = r"(?<!\w)lib%PART%(?=\.so\b|\.a\b)"
MODEL = (r"\bmodel://%NAME%(?=/)",)
URL = re.compile(r"https?://\S*")


def common_places(text: str, renamed: RenamedPackage, has_model: bool = False) -> Iterator[Span]:
    """Yield where a file names a package in a way that is the same in all kinds of files.

    `has_model` says that a model of Gazebo has the same name.
    """
    templates = [*SHARED, *(OF_INTERFACES if renamed.has_interfaces else ()), *(() if has_model else MODEL)]
    urls = [match.span() for match in URL.finditer(text)]
    every = (*found(templates, text, renamed.old), *found((OF_LIBRARY,), text, renamed.old, renamed.libraries))
    for span in every:
        if not any(start <= span.start < end for start, end in urls):
            yield span
