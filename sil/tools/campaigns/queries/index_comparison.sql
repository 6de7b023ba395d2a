-- every index with its threshold at 1, and the firmware's own warning: warned, early, lead, alarms
WITH statements AS (
    SELECT index_name, lifted, calm, band, lead_time_s, threshold >= 1 AS alarm FROM index_scores
    UNION ALL
    SELECT 'the firmware''s warning', lifted, calm, band, lead_time_s, warnings > 0 FROM drawn)
SELECT index_name,
       count(*) FILTER (lifted) AS lift_offs,
       round(100.0 * count(*) FILTER (lifted AND lead_time_s IS NOT NULL) / nullif(lift_offs, 0), 2) AS "warned, %",
       round(100.0 * count(*) FILTER (lifted AND lead_time_s >= 0.1 - 1e-6) / nullif(lift_offs, 0), 2) AS "0.1 s before, %",
       round(100.0 * count(*) FILTER (lifted AND lead_time_s >= 0.2 - 1e-6) / nullif(lift_offs, 0), 2) AS "0.2 s before, %",
       round(median(coalesce(lead_time_s, 0)) FILTER (lifted), 3) AS "median lead, s",
       round(100.0 * count(*) FILTER (calm AND alarm) / nullif(count(*) FILTER (calm), 0), 2) AS "alarms in calm runs, %",
       round(100.0 * count(*) FILTER (band = 'below 0.7' AND alarm) / nullif(count(*) FILTER (band = 'below 0.7'), 0), 2)
           AS "below 0.7, %"
FROM statements
GROUP BY index_name
ORDER BY "0.1 s before, %" DESC NULLS LAST, index_name;
