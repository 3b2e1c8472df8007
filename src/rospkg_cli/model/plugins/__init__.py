"""Plug-ins: what descriptions say of them, what sources export, who loads them."""
