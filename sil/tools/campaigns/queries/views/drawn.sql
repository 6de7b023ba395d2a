-- Runs that count in shares, which ordinary driving does not, with what docs/drives.md ("What counts") makes of them: lifted, calm,
-- warned, warned_100ms, warned_200ms, band.
CREATE VIEW drawn AS
SELECT *, unnest(judged(two_wheel_lift_time_s, lead_time_s, largest_ltr))
FROM runs
WHERE manoeuvre <> 'ordinary-driving';
