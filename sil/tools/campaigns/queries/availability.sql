-- how long the firmware makes no statement, and diagnostic codes, by manoeuvre; ordinary driving included
SELECT manoeuvre,
       count(*) AS runs,
       round(sum(end_time_s) / 3600, 2) AS "driven, h",
       round(sum(unavailable_duration_s), 2) AS "unavailable, s",
       round(100.0 * (1 - sum(unavailable_duration_s) / sum(end_time_s)), 4) AS "available, %",
       count(*) FILTER (unavailable_duration_s > 0) AS runs_with_a_gap,
       round(max(unavailable_duration_s), 2) AS "longest in a run, s",
       count(*) FILTER (diagnostic_codes <> '') AS runs_with_a_code,
       mode(diagnostic_codes) FILTER (diagnostic_codes <> '') AS "codes most often"
FROM runs
GROUP BY manoeuvre
ORDER BY "unavailable, s" DESC, manoeuvre;
