"""YAML files as entries that know file, line and key; numbers with unit, range and source."""
