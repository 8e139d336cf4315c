"""Sphinx's configuration: python3-sphinx and python3-numpydoc of Debian; the package must be importable."""
import trivet

project = "Trivet"
copyright = "the authors of Trivet"
version = release = trivet.__version__
extensions = ["sphinx.ext.autodoc", "numpydoc"]
exclude_patterns = ["_build", "notebooks/.ipynb_checkpoints"]
html_theme = "alabaster"
html_theme_options = {"description": "3D objects at rest, never through each other", "fixed_sidebar": True,
                      "page_width": "70em", "sidebar_width": "16em"}
html_show_sphinx = False
html_show_copyright = False
nitpicky = False
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # docstrings say them, with shapes and units
numpydoc_show_class_members = False
