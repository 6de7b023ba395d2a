-- What each entry says of each drawn run: the firmware's warning, every index with its threshold at 1, and the indicators that
-- were given in `changes` (entry, run, time_s, side: the warning that is in force from then on, or none).
CREATE VIEW given AS
WITH turns AS (
    SELECT *, side <> lag(side, 1, 'none') OVER (PARTITION BY entry, run ORDER BY time_s) AS turns FROM changes),
in_force AS (
    SELECT entry, run, arg_max(side, time_s) AS side, max(time_s) AS since_s
    FROM turns JOIN drawn USING (run)
    WHERE turns AND time_s <= two_wheel_lift_time_s + 1e-6
    GROUP BY entry, run),
alarms AS (SELECT DISTINCT entry, run FROM changes WHERE side <> 'none')
SELECT entry, run, vehicle, class, manoeuvre, lifted, calm, band,
       CASE WHEN in_force.side = falling_side THEN greatest(0, two_wheel_lift_time_s - since_s) END AS lead_time_s,
       alarms.run IS NOT NULL AS alarm
FROM (SELECT * FROM entries CROSS JOIN drawn)
LEFT JOIN in_force USING (entry, run)
LEFT JOIN alarms USING (entry, run);

CREATE VIEW statements AS
SELECT index_name AS entry, run, vehicle, class, manoeuvre, lifted, calm, band, lead_time_s, threshold >= 1 AS alarm
FROM index_scores
UNION ALL
SELECT 'the firmware''s warning', run, vehicle, class, manoeuvre, lifted, calm, band, lead_time_s, warnings > 0 FROM drawn
UNION ALL
SELECT * FROM given;
