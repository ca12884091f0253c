# Sphinx with MyST, both from Debian: cmake --build build/release --target docs
project = "stationary"
extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["deflist", "dollarmath"]
myst_heading_anchors = 3
html_theme = "alabaster"
html_theme_options = {"description": "Stationary ellipsoids of an affinely-rigid body", "nosidebar": False}
# Debian's own MathJax, so that the pages work offline.
mathjax_path = "file:///usr/share/javascript/mathjax/MathJax.js?config=TeX-AMS-MML_HTMLorMML"
exclude_patterns = ["_build"]
