-- the runs with the longest warning of the wrong side, and those with the wrong side as two wheels lift
SELECT run, vehicle, manoeuvre,
       wrong_side_duration_s AS "wrong side, s",
       falling_side, side_at_lift_off,
       round(largest_ltr, 3) AS "largest |LTR|",
       drive_again(run) AS "drives it again, and leaves its report.html"
FROM drawn
WHERE wrong_side_duration_s > 0 OR (lifted AND side_at_lift_off <> '' AND side_at_lift_off <> falling_side)
ORDER BY (lifted AND side_at_lift_off <> '' AND side_at_lift_off <> falling_side) DESC, wrong_side_duration_s DESC, run;
