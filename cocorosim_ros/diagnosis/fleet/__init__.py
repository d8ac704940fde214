"""Many recordings of many robots: each diagnosed by itself, resumable, then what they show together.

recordings    what lies in the folder of a fleet
outcome       what became of one recording, as a file
work          one recording diagnosed, in any process
dating        when a recording was made
processes     work in processes, each of which may die
store         the folder of outcomes, with which an interrupted fleet goes on
rows, table   a row for each robot and recording; the Parquet file
regression, drift, alike, in_common    what the rows show together
figures, sentence, page                fleet.html
"""
