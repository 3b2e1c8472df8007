"""Bodies of robots with the verdict of urdfdom; tests/real checks that it is its own."""

from __future__ import annotations

PAIR = '<link name="a"/><link name="b"/>'
JOINT = '<joint name="j" type="fixed"><parent link="a"/><child link="b"/>{}</joint>'
MOVING = JOINT.replace("fixed", "revolute")

TAKEN = [
    '<link name="a"/>', PAIR + JOINT.format(""), PAIR + MOVING.format('<limit effort="1" velocity="1."/>'),
    PAIR + JOINT.format('<origin xyz="0  0 .5" rpy="0 0 -1e-3"/>'), PAIR + JOINT.format('<axis xyz="nothing"/>'),
    '<material name="m"/>' + PAIR + JOINT.format(""), PAIR + JOINT.format('<dynamics damping="1"/>'),
    "<plugin/>",
]  # fmt: skip

REFUSED = [
    PAIR, PAIR + JOINT.format("").replace('"a"', '"c"'), PAIR + MOVING.format(""), PAIR + JOINT.replace("fixed", "x"),
    PAIR + MOVING.format('<limit effort="1"/>'), PAIR + MOVING.format('<limit effort="1" velocity="x"/>'),
    PAIR + JOINT.format('<origin xyz="0 0"/>'), PAIR + JOINT.format('<origin xyz="0,0,0"/>'),
    PAIR + JOINT.format('<origin xyz="0\n0 0"/>'), PAIR + JOINT.format("<dynamics/>"),
    PAIR + JOINT.format("<mimic/>"), PAIR + JOINT.format('<mimic joint="j" offset=" 1 "/>'),
    PAIR + PAIR + JOINT.format(""), PAIR + JOINT.format("") * 2, "<link/>" + PAIR + JOINT.format(""),
    PAIR + '<joint name="j" type="fixed"><parent link="a"/></joint>', PAIR + JOINT.replace(' type="fixed"', ""),
    PAIR + JOINT.format("") + JOINT.format("").replace('"a"', '"x"').replace('"b"', '"a"').replace('"x"', '"b"'),
    '<material name="m"/><material name="m"/>' + PAIR + JOINT.format(""),
]  # fmt: skip
