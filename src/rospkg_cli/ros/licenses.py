"""Licenses by their SPDX id: what they are called elsewhere, and which of them `new` can write.

Ids and deprecated ids: https://spdx.org/licenses/.  The sentence of CONTRIBUTING.md and the headers of source files
are those that ament_copyright (0.13 and later) recognises; the texts are in `templates/_shared/licenses`.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from .read_table import phrases


@dataclass(frozen=True)
class License:
    """One that `new` can write: the text, the header of each source file, and the line for contributors."""

    spdx: str
    called: str
    """How CONTRIBUTING.md must call it."""
    url: str
    header_known: bool = True
    """Whether ament_copyright knows the header."""


LICENSES: tuple[License, ...] = (
    License("Apache-2.0", "Apache 2 License", "http://www.apache.org/licenses/LICENSE-2.0.html"),
    License("BSD-2-Clause", "BSD 2-Clause Simplified License", "https://opensource.org/licenses/BSD-2-Clause"),
    License("BSD-3-Clause", "3-Clause BSD License", "https://opensource.org/licenses/BSD-3-Clause"),
    License("BSL-1.0", "Boost Software License - Version 1.0", "https://www.boost.org/LICENSE_1_0.txt"),
    License("GPL-3.0-only", "GNU General Public License", "https://opensource.org/licenses/GPL-3.0", False),
    License("GPL-3.0-or-later", "GNU General Public License", "https://opensource.org/licenses/GPL-3.0"),
    License("LGPL-3.0-only", "GNU Lesser General Public License", "https://opensource.org/licenses/LGPL-3.0", False),
    License("LGPL-3.0-or-later", "GNU Lesser General Public License", "https://opensource.org/licenses/LGPL-3.0"),
    License("MIT", "MIT license", "https://opensource.org/licenses/MIT"),
    License("MIT-0", "MIT-0 license", "https://opensource.org/licenses/MIT-0"),
)
"""ament_copyright's one header for the GPL offers "any later version": nothing that it knows says `-only`."""

CALLED: Mapping[str, tuple[str, ...]] = phrases("license_names.txt")
"""What else people write for an id; "BSD" and "GPL" alone are no one license."""

NOISE = regex(r"\b(the|licen[cs]e|version)\b|\bv(ersion)?\.?(?=\s*\d)|(?<=[a-z])v(?=\d)|[^a-z0-9+]")


def simplified(text: str) -> str:
    """Return a license's name without case, blanks, punctuation, and the words that every license has."""
    return NOISE.sub("", text.lower())


@cache
def ids_by_name() -> dict[str, str]:
    return {simplified(name): spdx for spdx, names in CALLED.items() for name in (spdx, *names)}


def spdx_id(text: str) -> str | None:
    """Return the SPDX id of the license that a text names; None where it is unknown.

    >>> spdx_id("Apache License, Version 2.0"), spdx_id("BSD-3-Clause"), spdx_id("BSD")
    ('Apache-2.0', 'BSD-3-Clause', None)
    """
    return ids_by_name().get(simplified(text))


def offered(spdx: str) -> License | None:
    """Return the license that `new` can write under an id."""
    return next((each for each in LICENSES if each.spdx == spdx), None)
