# Lift-offs warned of 0.2 s before, over the alarms that this costs: a curve for each index, a point for each other entry.
width = 1000
height = 620
load scripts."/picture_style.gp"
load scripts."/index_style.gp"
set datafile separator whitespace
unset datafile columnheaders

stats curves using 1:2 nooutput
curve_blocks = STATS_blocks
stats points using 1:2 nooutput
point_blocks = STATS_blocks
set xrange [0:80]
set yrange [0:102]
set xlabel "alarms in runs with a largest |LTR| of 0.8 to 0.9 [%]"
set ylabel "two-wheel lift-offs warned of at least 0.2 s before [%]"
names = ""
do for [i = 1:curve_blocks] { stats curves index i - 1 every ::0::0 using (names = names." ".strcol(1), 0) nooutput }
set key autotitle columnheader  # the first line of a block is its name
set key outside right Left reverse noenhanced samplen 2.5 spacing 1.15
plot for [i = 1:curve_blocks] curves index i - 1 using 1:2 with lines linewidth 2 dashtype index_dash(word(names, i)) \
         linecolor rgb index_colour(word(names, i)) title columnheader(1), \
     for [i = 1:point_blocks] points index i - 1 using 1:2 with points pointtype 4 + 2 * i pointsize 2.5 linewidth 2.5 \
         linecolor rgb black title columnheader(1)
