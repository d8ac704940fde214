"""What tables of results come to: effect sizes, sample sizes, box plots, a page to read."""
