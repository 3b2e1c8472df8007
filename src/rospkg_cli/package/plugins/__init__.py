"""Plugins: what descriptions say of them, and who loads them."""
