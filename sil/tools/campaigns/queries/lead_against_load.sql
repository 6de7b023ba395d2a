-- the lead over lift-off against the load, in steps of 0.01 of the sprung mass
SELECT floor(load_share / 0.01) * 0.01 AS "load from, share",
       count(*) AS lift_offs,
       count(*) FILTER (NOT warned) AS missed,
       round(quantile_cont(coalesce(lead_time_s, 0), 0.1), 3) AS "10th percentile, s",
       round(median(coalesce(lead_time_s, 0)), 3) AS "median lead, s",
       round(quantile_cont(coalesce(lead_time_s, 0), 0.9), 3) AS "90th percentile, s",
       round(avg(load_height_factor), 3) AS "mean height of the load, factor"
FROM drawn
WHERE lifted
GROUP BY "load from, share"
ORDER BY "load from, share";
