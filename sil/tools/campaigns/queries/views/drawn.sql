-- Runs that count in shares, which ordinary driving does not, with what docs/drives.md ("What counts") makes of them; the same as
-- sil/results/warning_judgement.hpp and sil/studies/campaign/detection.hpp.
CREATE VIEW drawn AS
SELECT *,
       two_wheel_lift_time_s IS NOT NULL AS lifted,
       lifted AND lead_time_s IS NOT NULL AS warned,
       lifted AND coalesce(lead_time_s >= 0.1 - 1e-6, false) AS warned_100ms,
       lifted AND coalesce(lead_time_s >= 0.2 - 1e-6, false) AS warned_200ms,
       NOT lifted AND largest_ltr < 0.9 AS calm,
       CASE WHEN lifted THEN 'two wheels lift'
            WHEN largest_ltr < 0.7 THEN 'below 0.7'
            WHEN largest_ltr < 0.8 THEN '0.7 to 0.8'
            WHEN largest_ltr < 0.9 THEN '0.8 to 0.9'
            ELSE '0.9 to lift' END AS band
FROM runs
WHERE manoeuvre <> 'ordinary-driving';
