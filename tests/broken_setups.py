"""Packages with one fault each in setup.py or setup.cfg that `--fix` mends: what is broken, and of which rule."""

from __future__ import annotations

from dataclasses import dataclass, field

from rospkg_cli.example import manifest

NODE = "import rclpy\n\n\ndef main():\n    print('hello from', rclpy.__name__)\n"
LAUNCH = "<launch>\n</launch>\n"
SETUP = """\
# The setup of NAME.  These comments and the quotes stay as they are.
from glob import glob  # for the launch files

from setuptools import find_packages, setup

package_name = "NAME"  # also the name of the folder

setup(
    name=package_name,
    version='1.0.0',  # as in package.xml
    packages=find_packages(exclude=['test']),
    data_files=[
        # the index first
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),  # then the manifest
        ('share/' + package_name + "/launch", glob('launch/*launch.[pxy][yma]*')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer="Ada",
    maintainer_email='ada@example.org',
    description='Drives my robot',
    license='Apache-2.0',  # SPDX
    extras_require={'test': ['pytest']},
    entry_points={
        'console_scripts': [
            'talker = NAME.talker:main',  # says hello
            "listener = NAME.listener:main",
        ],
    },
)
"""
CFG = "[develop]\nscript_dir=$base/lib/NAME\n[install]\ninstall_scripts=$base/lib/NAME\n"
FILES: dict[str, str | None] = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n", name="NAME"),
    "setup.py": SETUP,
    "setup.cfg": CFG,
    "resource/NAME": "",
    "NAME/__init__.py": "",
    "NAME/talker.py": NODE,
    "NAME/listener.py": NODE,
    "launch/a.launch.xml": LAUNCH,
}


@dataclass(frozen=True)
class Broken:
    code: str
    files: dict[str, str | None] = field(default_factory=dict)
    """What differs from the right package; None: the file is absent."""
    old: str = ""
    """What is replaced in setup.py …"""
    new: str = ""
    """… and by what."""

    def of(self, name: str) -> dict[str, str]:
        changed = {**FILES, "setup.py": SETUP.replace(self.old, self.new) if self.old else SETUP, **self.files}
        return {
            path.replace("NAME", name): text.replace("NAME", name) for path, text in changed.items() if text is not None
        }


MARKER = "        ('share/ament_index/resource_index/packages',\n            ['resource/' + package_name]),\n"
MANIFEST = "        ('share/' + package_name, ['package.xml']),  # then the manifest\n"
SHARED = "        ('share/' + package_name + \"/launch\", glob('launch/*launch.[pxy][yma]*')),\n"
TALKER = "            'talker = NAME.talker:main',  # says hello\n"
FOUND = "find_packages(exclude=['test'])"
DATA = SETUP[SETUP.index("    data_files=[") : SETUP.index("    install_requires")]
WORDS: dict[str, str | None] = {
    "NAME/talker.py": NODE.replace(
        "import rclpy\n", "import rclpy\n\nfrom NAME.speech.words import GREETING  # noqa\n"
    ),
    "NAME/speech/words.py": "GREETING = 'hello'\n",
}

BROKEN: dict[str, Broken] = {
    "no_cfg": Broken("SET001", {"setup.cfg": None}),
    "other_cfg": Broken("SET002", {"setup.cfg": CFG.replace("NAME", "other_pkg")}),
    "half_cfg": Broken("SET002", {"setup.cfg": "# mine\n[develop]\nscript_dir=$base/lib/NAME"}),
    "dashes": Broken("SET003", {"setup.cfg": CFG.replace("_dir", "-dir").replace("_scripts", "-scripts")}),
    "joined": Broken("SET103", old="talker:main',  # says hello", new="talker:main'  # says hello"),
    "no_function": Broken("SET103", old="NAME.talker:main", new="NAME.talker.main"),
    "a_file": Broken("SET103", old="NAME.talker:main", new="NAME/talker.py:main"),
    "unlisted_node": Broken(
        "SET105",
        {
            "NAME/deep/__init__.py": "",
            "NAME/deep/node.py": NODE,
            "setup.py": SETUP.replace(FOUND, "[package_name]").replace(
                TALKER, TALKER + "            'deep = NAME.deep.node:main',\n"
            ),
        },
    ),
    "no_marker": Broken("SET201", old=MARKER, new=""),
    "other_marker": Broken("SET201", {"resource/other": ""}, "'resource/' + package_name", "'resource/other'"),
    "lost_marker": Broken("SET202", {"resource/NAME": None}),
    "no_manifest": Broken("SET203", old=MANIFEST, new=""),
    "nothing_shared": Broken("SET201", old=DATA, new=""),
    "no_launch": Broken("SET206", old=SHARED, new=""),
    "missed_launch": Broken(
        "SET207", {"launch/b_launch.xml": LAUNCH}, "launch/*launch.[pxy][yma]*", "launch/*.launch.xml"
    ),
    "elsewhere": Broken("SET208", old="'share/' + package_name + \"/launch\"", new="'share/launch'"),
    "twice": Broken("SET209", old=MANIFEST, new=MANIFEST + "        ('share/' + package_name, ['package.xml']),\n"),
    "no_init": Broken("SET301", WORDS),
    "unlisted": Broken("SET302", {**WORDS, "NAME/speech/__init__.py": ""}, FOUND, "[package_name]"),
    "tests_too": Broken("SET303", {"test/__init__.py": ""}, FOUND, "find_packages()"),
    "tests_require": Broken("SET304", old="extras_require={'test': ['pytest']}", new="tests_require=['pytest']"),
    "classifier": Broken(
        "SET305",
        old="    zip_safe",
        new="    classifiers=[\n        'License :: OSI Approved',\n        'Topic :: Robots',\n    ],\n    zip_safe",
    ),
    "requires": Broken("SET306", old="['setuptools']", new="['setuptools', 'std_msgs']"),
    "other_name": Broken("SET401", old="    name=package_name", new='    name="other_name_of_it"'),
    "other_version": Broken("SET402", old="'1.0.0'", new="'0.0.0'"),
    "other_license": Broken("SET403", old="'Apache-2.0'", new="'TODO: License declaration'"),
    "other_maintainer": Broken("SET403", old='"Ada"', new='"Charles"'),
}
