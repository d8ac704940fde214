"""What `import cocorosim_ros` gives: the work of the commands as functions, their results as records."""
