from dataclasses import dataclass


@dataclass
class String:
    data: str = ""


@dataclass
class Header:
    stamp: object = None
    frame_id: str = ""
