"""Plugins: their descriptions, their loaders, and references to them."""
