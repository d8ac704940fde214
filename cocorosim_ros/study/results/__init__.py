"""Tables of results: effect sizes, sample sizes, box plots, a page to read."""
