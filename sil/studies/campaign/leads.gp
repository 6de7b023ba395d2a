# Lead times: the share of all two-wheel lift-offs that are warned of at least so early, every threshold at 1.
width = 1000
height = 620
load scripts."/picture_style.gp"
load scripts."/index_style.gp"
load "report.gp"

lead_of(wanted) = strcol("index") eq wanted ? column("lead_time_s") : NaN

set xrange [0:1.5]
set yrange [0:100.5]
set xlabel "lead of the warning of the right side before two-wheel lift-off [s]"
set ylabel "lift-offs with at least this lead [%]"
set key outside right top Left reverse noenhanced samplen 2.5 spacing 1.15
set title sprintf("%d two-wheel lift-offs, every threshold at 1", lifted_runs)
set arrow from 0.1, graph 0 to 0.1, graph 1 nohead dashtype 2 linecolor rgb grey
set arrow from 0.2, graph 0 to 0.2, graph 1 nohead dashtype 2 linecolor rgb grey
plot "leads.csv" using (lead_of("warning")):(100 * column("share_with_at_least")) \
         with lines linewidth 3.5 linecolor rgb black title "the firmware's warning", \
     for [i = 1:words(index_names)] "" \
         using (lead_of(word(index_names, i))):(100 * column("share_with_at_least")) \
         with lines linewidth 2 dashtype index_dash(word(index_names, i)) \
         linecolor rgb index_colour(word(index_names, i)) title word(index_names, i)
