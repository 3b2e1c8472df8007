"""Names from elsewhere for what rosdep and ROS 2 call otherwise: PyPI, Ubuntu, CMake, ROS 1."""

from __future__ import annotations

import re

from .distros import DISTROS
from .imports import keys_called_like
from .names import BUILT_IN, Names
from .read_table import rows

PYPI = {
    "beautifulsoup4": "python3-bs4",
    "gitpython": "python3-git",
    "grpcio": "python3-grpcio",
    "lark": "python3-lark-parser",
    "msgpack-python": "python3-msgpack",
    "opencv-contrib-python": "python3-opencv",
    "opencv-python": "python3-opencv",
    "opencv-python-headless": "python3-opencv",
    "paho-mqtt": "python3-paho-mqtt",
    "pillow": "python3-pil",
    "protobuf": "python3-protobuf",
    "pyaudio": "python3-pyaudio",
    "pyqt5": "python3-pyqt5",
    "pyserial": "python3-serial",
    "python-can": "python3-can",
    "python-dateutil": "python3-dateutil",
    "python-dotenv": "python3-dotenv",
    "pyusb": "python3-usb",
    "pyyaml": "python3-yaml",
    "pyzmq": "python3-zmq",
    "scikit-image": "python3-skimage",
    "scikit-learn": "python3-sklearn",
    "websocket-client": "python3-websocket",
}
"""Names on PyPI whose key is called like something else, by normalised name (PEP 503)."""

OF_ROS = re.compile(rf"ros-(?:{'|'.join(each.name for each in DISTROS)})-([a-z0-9-]+)")
"""What Ubuntu's packages of ROS packages are called."""

NOTHING_NEEDED = "-"


def key_for_pip(name: str, names: Names = BUILT_IN) -> str | None:
    """Return the rosdep key for a name on PyPI; None where none is known."""
    normal = re.sub(r"[-_.]+", "-", name).lower()
    if normal in PYPI:
        return PYPI[normal]
    likely = [key for key in keys_called_like(normal) if names.is_key(key)]
    listed = {re.sub(r"[-_.]+", "-", pip).lower(): keys for pip, keys in names.pip.items()}
    return next(iter([*likely, *listed.get(normal, ())]), None)


def key_for_apt(name: str, names: Names = BUILT_IN) -> str | None:
    """Return the rosdep key, or the ROS package, for a package of Ubuntu that is called otherwise; else None."""
    released = OF_ROS.fullmatch(name)
    if released:
        package = released[1].replace("-", "_")
        return package if names.is_package(package) else None
    keys = names.apt.get(name, ())
    return keys[0] if len(keys) == 1 and "-" in name and not names.is_key(name) else None


def keys_for_cmake(name: str) -> tuple[str, ...]:
    """Return what serves find_package(name), the preferred one first; a pattern (`libopencv-*`) may stand among them.

    No name where the table has none; `-` among them says that nothing has to be declared.
    """
    return rows("cmake.txt").get(name, ())


def successors(name: str) -> tuple[str, ...] | None:
    """Return what took the place of a ROS 1 package; None for a name that is not ROS 1's alone."""
    found = rows("ros1.txt").get(name)
    return None if found is None else tuple(each for each in found if each != NOTHING_NEEDED)
