-- lift-offs warned of, early, and alarms in calm runs, of each manoeuvre with each class of vehicles
SELECT manoeuvre, class,
       count(*) AS runs,
       count(*) FILTER (lifted) AS lift_offs,
       count(*) FILTER (lifted AND NOT warned) AS missed,
       round(100.0 * count(*) FILTER (warned) / nullif(lift_offs, 0), 2) AS "warned, %",
       round(100.0 * count(*) FILTER (warned_100ms) / nullif(lift_offs, 0), 2) AS "0.1 s before, %",
       round(100.0 * count(*) FILTER (warned_200ms) / nullif(lift_offs, 0), 2) AS "0.2 s before, %",
       round(median(coalesce(lead_time_s, 0)) FILTER (lifted), 3) AS "median lead, s",
       count(*) FILTER (calm) AS calm_runs,
       round(100.0 * count(*) FILTER (calm AND warnings > 0) / nullif(calm_runs, 0), 2) AS "alarms in calm runs, %"
FROM drawn
GROUP BY manoeuvre, class
ORDER BY manoeuvre, class;
