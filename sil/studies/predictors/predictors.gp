# Lift-offs warned of 0.2 s before, over the alarms that this costs in runs that came close: one curve a prediction.
width = 1000
height = 620
load scripts."/picture_style.gp"
load scripts."/index_style.gp"
set datafile separator whitespace
unset datafile columnheaders

set key autotitle columnheader  # the first line of a block is its name
stats curves using 1:2 nooutput
set xrange [0:80]
set yrange [40:100.5]
set xlabel "alarms in runs with a largest |LTR| of 0.8 to 0.9 [%]"
set ylabel "two-wheel lift-offs warned of at least 0.2 s before [%]"
set key bottom right Left reverse noenhanced samplen 2.5 spacing 1.15
# The first block is the firmware as it is: one point.
plot for [i = 1:STATS_blocks - 1] curves index i using 1:2 with linespoints linewidth 2 pointtype 7 pointsize 0.5 \
         dashtype other_dash(i) linecolor rgb other_colour(i) title columnheader(1), \
     curves index 0 using 1:2 with points pointtype 6 pointsize 2.5 linewidth 2.5 linecolor rgb black \
         title columnheader(1)
