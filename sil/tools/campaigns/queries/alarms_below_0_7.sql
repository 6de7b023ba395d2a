-- alarms in runs whose largest |LTR| stays below 0.7, each with the command that drives it again
SELECT run, vehicle, class, manoeuvre,
       round(largest_ltr, 3) AS "largest |LTR|",
       warning_time_s AS "first warning, s",
       warning_duration_s AS "warning, s",
       diagnostic_codes,
       drive_again(run) AS "drives it again, and leaves its report.html"
FROM drawn
WHERE band = 'below 0.7' AND warnings > 0
ORDER BY largest_ltr, run;
