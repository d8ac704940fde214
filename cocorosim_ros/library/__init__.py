"""What `import cocorosim_ros` gives: the work of each command as a function, and its result as a record."""
