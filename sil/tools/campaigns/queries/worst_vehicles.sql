-- vehicles with the fewest lift-offs warned of 0.1 s before, of those with 20 lift-offs or more
SELECT vehicle, class,
       count(*) AS runs,
       count(*) FILTER (lifted) AS lift_offs,
       count(*) FILTER (lifted AND NOT warned) AS missed,
       round(100.0 * count(*) FILTER (warned) / count(*) FILTER (lifted), 2) AS "warned, %",
       round(100.0 * count(*) FILTER (warned_100ms) / count(*) FILTER (lifted), 2) AS "0.1 s before, %",
       round(100.0 * count(*) FILTER (warned_200ms) / count(*) FILTER (lifted), 2) AS "0.2 s before, %",
       round(100.0 * count(*) FILTER (calm AND warnings > 0) / nullif(count(*) FILTER (calm), 0), 2) AS "alarms in calm runs, %",
       round(sum(wrong_side_duration_s), 2) AS "wrong side, s"
FROM drawn
GROUP BY vehicle, class
HAVING lift_offs >= 20
ORDER BY "0.1 s before, %", missed DESC, vehicle
LIMIT 30;
