"""What is asked for: scenarios, platforms and controllers, as frozen records read from YAML."""
