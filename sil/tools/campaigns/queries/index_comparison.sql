-- every index with its threshold at 1, the firmware's own warning, and what `score` was given: warned, early, lead, alarms
WITH totals AS (
    SELECT count(*) FILTER (lifted) AS lift_offs,
           count(*) FILTER (calm) AS calm_runs,
           count(*) FILTER (band = 'below 0.7') AS runs_below,
           count(*) FILTER (band = '0.7 to 0.8') AS runs_from_0_7,
           count(*) FILTER (band = '0.8 to 0.9') AS runs_from_0_8
    FROM drawn)
SELECT entry AS index_name, lift_offs,
       round(100.0 * count(*) FILTER (warned) / nullif(lift_offs, 0), 2) AS "warned, %",
       round(100.0 * count(*) FILTER (warned_100ms) / nullif(lift_offs, 0), 2) AS "0.1 s before, %",
       round(100.0 * count(*) FILTER (warned_200ms) / nullif(lift_offs, 0), 2) AS "0.2 s before, %",
       round(median(coalesce(lead_time_s, 0)) FILTER (lifted), 3) AS "median lead, s",
       round(100.0 * count(*) FILTER (calm) / nullif(calm_runs, 0), 2) AS "alarms in calm runs, %",
       round(100.0 * count(*) FILTER (band = 'below 0.7') / nullif(runs_below, 0), 2) AS "below 0.7, %",
       round(100.0 * count(*) FILTER (band = '0.7 to 0.8') / nullif(runs_from_0_7, 0), 2) AS "0.7 to 0.8, %",
       round(100.0 * count(*) FILTER (band = '0.8 to 0.9') / nullif(runs_from_0_8, 0), 2) AS "0.8 to 0.9, %"
FROM statements, totals
WHERE lifted OR alarm
GROUP BY entry, lift_offs, calm_runs, runs_below, runs_from_0_7, runs_from_0_8
ORDER BY "0.1 s before, %" DESC NULLS LAST, index_name;
