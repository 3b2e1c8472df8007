"""What people write for a license, and the SPDX id that it stands for."""

from __future__ import annotations

import pytest

from rospkg_cli.ros.licenses import CALLED, LICENSES, ids_by_name, offered, simplified, spdx_id

WRITTEN = {
    "Apache License 2.0": "Apache-2.0",
    "Apache License, Version 2.0": "Apache-2.0",
    "apache2.0": "Apache-2.0",
    "Apache v2": "Apache-2.0",
    "The Apache License 2.0": "Apache-2.0",
    "3-Clause BSD": "BSD-3-Clause",
    "BSD-3-Clause License": "BSD-3-Clause",
    "BSD 2-Clause Simplified License": "BSD-2-Clause",
    "MIT License": "MIT",
    "mit": "MIT",
    "GPLv3": "GPL-3.0-only",
    "GPL-3.0": "GPL-3.0-only",
    "GPLv3+": "GPL-3.0-or-later",
    "GNU General Public License v3.0": "GPL-3.0-only",
    "LGPL-2.1": "LGPL-2.1-only",
    "Boost Software License 1.0": "BSL-1.0",
    "Mozilla Public License Version 2.0": "MPL-2.0",
}


@pytest.mark.parametrize("text, spdx", WRITTEN.items())
def test_what_people_write(text: str, spdx: str) -> None:
    assert spdx_id(text) == spdx


@pytest.mark.parametrize("text", ["BSD", "GPL", "LGPL", "TODO: License declaration", "", "Proprietary", "Apache, MIT"])
def test_what_cannot_be_told(text: str) -> None:
    assert spdx_id(text) is None


def test_no_name_stands_for_two_ids() -> None:
    assert len(ids_by_name()) == sum(1 + len(names) for names in CALLED.values()) - same_when_simplified()


def same_when_simplified() -> int:
    """Return how many names of one license fall together."""
    return sum(1 + len(names) - len({simplified(n) for n in (spdx, *names)}) for spdx, names in CALLED.items())


def test_every_license_that_can_be_written_is_known_by_its_id() -> None:
    for each in LICENSES:
        assert spdx_id(each.spdx) == each.spdx
        assert offered(each.spdx) == each
    assert offered("MPL-2.0") is None
