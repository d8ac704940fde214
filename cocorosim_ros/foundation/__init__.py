"""What everything else stands on: errors, output files, units, compiled code. Nothing here knows robots."""
