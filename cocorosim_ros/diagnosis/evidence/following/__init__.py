"""Following of commands by what actuators report: told from the recordings alone, before any physics."""
