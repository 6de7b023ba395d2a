# Detection against false alarms while the threshold moves: above, any warning before lift-off; below, 0.1 s before.
width = 1150
height = 1150
load scripts."/picture_style.gp"
load scripts."/../studies/campaign/index_style.gp"
load "report.gp"

share(name, wanted) = strcol("index") eq wanted ? 100 * column(name) : NaN

set xrange [0:5]
set yrange [50:100.5]
set ylabel "two-wheel lift-offs warned of [%]"
set rmargin at screen 0.77
set key at screen 0.785, graph 1 left top Left reverse noenhanced samplen 2.5 spacing 1.15
set multiplot layout 2,1 title sprintf("%d runs, %d two-wheel lift-offs, %d without wheel lift", \
    runs, lifted_runs, calm_runs) font ",13"
set title "warned before lift-off"
plot for [i = 1:words(index_names)] "curves.csv" \
         using (share("false_alarm_share", word(index_names, i))):(share("warned_share", word(index_names, i))) \
         with lines linewidth 2 dashtype dash_of(i) linecolor rgb colour_of(i) title word(index_names, i), \
     "+" every ::::0 using (100 * warning_false_alarm_share):(100 * warning_warned_share) \
         with points pointtype 7 pointsize 1.6 linecolor rgb black title "the firmware's warning"
set title "warned 0.1 s or more before"
set xlabel "alarms in runs without wheel lift [%]"
unset key
plot for [i = 1:words(index_names)] "curves.csv" \
         using (share("false_alarm_share", word(index_names, i))):(share("warned_100ms_share", word(index_names, i))) \
         with lines linewidth 2 dashtype dash_of(i) linecolor rgb colour_of(i), \
     "+" every ::::0 using (100 * warning_false_alarm_share):(100 * warning_warned_100ms_share) \
         with points pointtype 7 pointsize 1.6 linecolor rgb black
unset multiplot
