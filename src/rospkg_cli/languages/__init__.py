"""Parsers and evaluators: text in, tree or value with positions out. They know nothing of ROS."""
