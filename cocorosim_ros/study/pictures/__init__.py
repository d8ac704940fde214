"""Pictures of runs, drawn without a display and without global state."""
