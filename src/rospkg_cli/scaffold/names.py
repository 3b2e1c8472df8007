"""Which names a package and a node may have, and the reason where one may not."""

from __future__ import annotations

import keyword
import re
import sys

from ..ros.interfaces import CPP_KEYWORDS
from ..ros.manifest import PACKAGE_NAME
from . import ScaffoldError

LONGEST = 60
"""Longer names break the line length of the linters in places where no line can be broken."""

ALSO_STDLIB = frozenset(
    "aifc asynchat asyncore audioop binhex cgi cgitb chunk compression crypt distutils imghdr imp mailcap msilib nis "
    "nntplib ossaudiodev pipes smtpd sndhdr spwd sunau telnetlib test uu xdrlib".split()
)
"""`test`, and modules that one Python between 3.10 and 3.14 has and another lacks."""

TAKEN = frozenset(
    "ament_copyright ament_flake8 ament_index_python ament_mypy ament_pep257 ament_xmllint launch launch_ros "
    "launch_testing numpy pip pkg_resources pytest rcl_interfaces rclcpp rclpy setuptools std_msgs wheel yaml "
    "action build config include install log msg resource rviz scripts src srv tests urdf".split()
)
"""What packages of ROS import, and what folders in them are called."""


def check_package_name(name: str) -> None:
    """Raise ScaffoldError for a name that no package should have."""
    check_form("package", name)
    if name in CPP_KEYWORDS:
        raise ScaffoldError(f"`{name}` is a keyword of C++: no C++ code could use its namespace; {another(name)}")
    if name in sys.stdlib_module_names or name in ALSO_STDLIB:
        raise ScaffoldError(f"`{name}` is a module of Python itself, and one would hide the other; {another(name)}")
    if name in TAKEN:
        raise ScaffoldError(
            f"`{name}` is taken: packages of ROS import that name, or keep a folder under it; {another(name)}"
        )


def check_node_name(name: str, package: str) -> None:
    """Raise ScaffoldError for a name that no node of the package should have."""
    check_form("node", name)
    if name == package:
        reason = "the module would have the name of its package, and `import` could find the wrong one"
        raise ScaffoldError(f"a node can't be called like its package: {reason}; try `{name}_node`")
    if name == "conftest":
        raise ScaffoldError(
            "pytest takes a module `conftest` for its own setup, and would import it; choose another name"
        )


def check_form(what: str, name: str) -> None:
    """Raise ScaffoldError where a name is not of the form that schema, REP-144 and Python want."""
    if not PACKAGE_NAME.fullmatch(name) or len(name) < 2:
        better = repaired(name)
        hint = f"; try `{better}`" if better else ""
        raise ScaffoldError(
            f"`{name}` can't be the name of a {what}: two or more lowercase letters, digits and single underscores, "
            f"with a letter first and no underscore at the end{hint}"
        )
    if len(name) > LONGEST:
        raise ScaffoldError(f"`{name}` is too long for the name of a {what}: {len(name)} characters; at most {LONGEST}")
    if keyword.iskeyword(name):
        raise ScaffoldError(f"`{name}` is a keyword of Python: nothing could import it; {another(name)}")


def another(name: str) -> str:
    return f"try `my_{name}`"


UNFOLDED = str.maketrans({"ß": "ss", "æ": "ae", "ø": "o", "đ": "d", "ł": "l", "ı": "i"})
"""Letters that Unicode takes for no accented ones."""


def repaired(name: str) -> str:
    """Return the nearest name of the right form: without accents, with a letter first; "" where there is none."""
    from unicodedata import normalize

    plain = re.sub(r"[\u0300-\u036f]", "", normalize("NFKD", name.translate(UNFOLDED)))
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", plain).lower()
    words = re.sub(r"[^a-z0-9]+", "_", words).strip("_")
    words = f"my_{words}" if words[:1].isdigit() or len(words) == 1 else words
    return words if PACKAGE_NAME.fullmatch(words) else ""
