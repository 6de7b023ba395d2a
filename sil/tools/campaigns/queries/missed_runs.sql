-- lift-offs without a warning of the right side in force, each with the command that drives it again
SELECT run, vehicle, class, manoeuvre,
       two_wheel_lift_time_s AS "two wheels lift, s",
       warning_time_s AS "first warning, s",
       falling_side, side_at_lift_off,
       unavailable_duration_s AS "unavailable, s",
       drive_again(run) AS "drives it again, and leaves its report.html"
FROM drawn
WHERE lifted AND NOT warned
ORDER BY run;
