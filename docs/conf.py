"""Settings of the site, which `make docs` builds.

Sphinx with MyST and furo: mkdocs-material is no longer developed further, and pages stay plain Markdown either way.
"""

import sys
from importlib import import_module
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[1])]  # site_builder, and this tree's package

project = "cocorosim_ros"
author = "cocorosim_ros maintainers"
version = release = import_module("cocorosim_ros").__version__

extensions = ["myst_nb", "site_builder"]
exclude_patterns = ["paper", "site_builder"]
myst_heading_anchors = 4  # links to headings, as GitHub makes them
nb_execution_mode = "force"  # notebooks are stored without outputs
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 900  # s for one cell; only compiling for the first time on a busy machine takes long

html_theme = "furo"
html_title = "cocorosim_ros"
html_show_sourcelink = False
html_show_copyright = False
html_copy_source = False
highlight_language = "text"  # commands, and what they print
