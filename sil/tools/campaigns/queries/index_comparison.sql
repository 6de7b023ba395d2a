-- every index with its threshold at 1, and the firmware's own warning: warned, early, lead, alarms
WITH totals AS (
    SELECT count(*) FILTER (lifted) AS lift_offs,
           count(*) FILTER (calm) AS calm_runs,
           count(*) FILTER (band = 'below 0.7') AS runs_below
    FROM drawn),
statements AS (
    SELECT index_name, lifted, calm, largest_ltr, lead_time_s FROM index_scores WHERE lifted OR threshold >= 1
    UNION ALL
    SELECT 'the firmware''s warning', lifted, calm, largest_ltr, lead_time_s FROM drawn WHERE lifted OR warnings > 0)
SELECT index_name, lift_offs,
       round(100.0 * count(lead_time_s) FILTER (lifted) / nullif(lift_offs, 0), 2) AS "warned, %",
       round(100.0 * count(*) FILTER (lifted AND lead_time_s >= 0.1 - 1e-6) / nullif(lift_offs, 0), 2) AS "0.1 s before, %",
       round(100.0 * count(*) FILTER (lifted AND lead_time_s >= 0.2 - 1e-6) / nullif(lift_offs, 0), 2) AS "0.2 s before, %",
       round(median(coalesce(lead_time_s, 0)) FILTER (lifted), 3) AS "median lead, s",
       round(100.0 * count(*) FILTER (calm) / nullif(calm_runs, 0), 2) AS "alarms in calm runs, %",
       round(100.0 * count(*) FILTER (NOT lifted AND largest_ltr < 0.7) / nullif(runs_below, 0), 2) AS "below 0.7, %"
FROM statements, totals
GROUP BY index_name, lift_offs, calm_runs, runs_below
ORDER BY "0.1 s before, %" DESC NULLS LAST, index_name;
