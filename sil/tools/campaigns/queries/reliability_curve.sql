-- share of two-wheel lift-offs in runs whose default index reaches a threshold, by steps of 0.05
SELECT round(floor(threshold / 0.05) * 0.05, 2) AS "reaches",
       count(*) AS runs,
       count(*) FILTER (lifted) AS lift_offs,
       round(100.0 * count(*) FILTER (lifted) / count(*), 2) AS "lift two wheels, %",
       round(100.0 * sum(count(*) FILTER (lifted)) OVER reached / sum(count(*)) OVER reached, 2) AS "of all that reach it, %"
FROM index_scores
WHERE index_name = 'predicted_load_transfer'
GROUP BY "reaches"
WINDOW reached AS (ORDER BY "reaches" DESC)
ORDER BY "reaches";
