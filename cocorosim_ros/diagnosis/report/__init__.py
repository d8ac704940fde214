"""What a diagnosis has found, for people and for programs: diagnosis.json, model.yaml, report.html."""
