-- alarms and advisories by how near a run comes to lift-off, for each class of vehicles
SELECT class, band,
       count(*) AS runs,
       count(*) FILTER (warnings > 0) AS runs_with_alarm,
       round(100.0 * runs_with_alarm / count(*), 2) AS "with alarm, %",
       round(100.0 * count(*) FILTER (advisories > 0) / count(*), 2) AS "with advisory, %",
       round(sum(warning_duration_s), 1) AS "warning, s"
FROM drawn
GROUP BY class, band
ORDER BY class, min(least(largest_ltr, 1)), band;
