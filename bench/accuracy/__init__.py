"""How often is rospkg right about packages that it has never seen?

`python -m bench.accuracy count FOLDER…` says how much is reported, per package; `sheet` draws findings to be judged by
hand, and `tally` adds up what two judges said of them.
"""
