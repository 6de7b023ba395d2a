-- Statement of each entry on each drawn run: the firmware's warning, every index with its threshold at 1, and the
-- given indicators (entry, run, lead_time_s, alarm).
CREATE VIEW statements AS
WITH said AS (
    SELECT index_name AS entry, run, lead_time_s, threshold >= 1 AS alarm FROM index_scores
    UNION ALL
    SELECT 'the firmware''s warning', run, lead_time_s, warnings > 0 FROM drawn
    UNION ALL
    SELECT * FROM given)
SELECT entry, run, vehicle, class, manoeuvre, said.lead_time_s, alarm,
       unnest(judged(two_wheel_lift_time_s, said.lead_time_s, largest_ltr))
FROM said JOIN runs USING (run);
