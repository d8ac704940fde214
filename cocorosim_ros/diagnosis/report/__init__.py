"""Files about a diagnosis, for people and for programs: diagnosis.json, model.yaml, report.html."""
