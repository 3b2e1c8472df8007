"""What common modules of Python's standard library have, and what is often looked for in them in vain."""

from __future__ import annotations

from collections.abc import Mapping

from .read_table import sets

ATTRIBUTES: Mapping[str, frozenset[str]] = sets("module_attributes.txt")
MEANT: Mapping[str, str] = {
    **{f"collections.{name}": f"collections.abc.{name}" for name in ATTRIBUTES["collections.abc"]},
    **{f"datetime.{name}": f"datetime.datetime.{name}" for name in ("now", "strptime", "utcnow", "fromtimestamp")},
    "datetime.today": "datetime.date.today",
    "fractions.gcd": "math.gcd",
    "itertools.ifilter": "filter",
    "itertools.imap": "map",
    "itertools.izip": "zip",
    "math.abs": "abs",
    "math.max": "max",
    "math.min": "min",
    "math.round": "round",
    "os.getcwdu": "os.getcwd",
    "os.mkdirs": "os.makedirs",
    "os.sleep": "time.sleep",
    "os.path.listdir": "os.listdir",
    "os.path.makedirs": "os.makedirs",
    "os.path.mkdir": "os.mkdir",
    "os.path.walk": "os.walk",
    "sys.maxint": "sys.maxsize",
    "time.clock": "time.perf_counter",
    "time.now": "time.time",
    "xml.etree.ET": "import xml.etree.ElementTree as ET",
    "xml.etree.ElementTree.ET": "import xml.etree.ElementTree as ET",
    **{f"os.{name}": f"os.path.{name}" for name in ATTRIBUTES["os.path"] - ATTRIBUTES["os"] if name.islower()},
}
"""Names that no Python 3 of ROS 2 has, and what to write instead."""

IN_FOXY = frozenset({"fractions.gcd", *(name for name in MEANT if name.startswith("collections."))})
"""Those that Python 3.8 still has, which Foxy and Galactic run on."""

OPEN = frozenset({"sys"})
"""Modules to which programs add names; only misspelt ones are wrong there."""

BY_PLATFORM = frozenset({"fcntl", "logging", "os", "select", "signal", "socket", "termios", "time"})
"""Modules whose constants depend on the platform, or are added by libraries."""
