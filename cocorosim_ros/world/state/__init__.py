"""What flows between the stages: records of arrays with leading axes (runs, robots)."""
