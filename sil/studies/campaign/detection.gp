# Detection against false alarms while the threshold moves: as the wheels lift, 0.1 s and 0.2 s before.
width = 1150
height = 1650
load scripts."/picture_style.gp"
load scripts."/../studies/campaign/index_style.gp"
load "report.gp"

share(name, wanted) = strcol("index") eq wanted ? 100 * column(name) : NaN

set xrange [0:5]
set yrange [50:100.5]
set ylabel "two-wheel lift-offs warned of [%]"
set rmargin at screen 0.77
set key at screen 0.785, graph 1 left top Left reverse noenhanced samplen 2.5 spacing 1.15
set multiplot layout 3,1 title sprintf("%d runs, %d two-wheel lift-offs, %d calm runs", \
    runs, lifted_runs, calm_runs) font ",13"
set title "in force with the right side as the wheels lift"
plot for [i = 1:words(index_names)] "curves.csv" \
         using (share("false_alarm_share", word(index_names, i))):(share("warned_share", word(index_names, i))) \
         with lines linewidth 2 dashtype dash_of(i) linecolor rgb colour_of(i) title word(index_names, i), \
     "+" every ::::0 using (100 * warning_false_alarm_share):(100 * warning_warned_share) \
         with points pointtype 7 pointsize 1.6 linecolor rgb black title "the firmware's warning"
set title "for 0.1 s or more"
unset key
plot for [i = 1:words(index_names)] "curves.csv" \
         using (share("false_alarm_share", word(index_names, i))):(share("warned_100ms_share", word(index_names, i))) \
         with lines linewidth 2 dashtype dash_of(i) linecolor rgb colour_of(i), \
     "+" every ::::0 using (100 * warning_false_alarm_share):(100 * warning_warned_100ms_share) \
         with points pointtype 7 pointsize 1.6 linecolor rgb black
set title "for 0.2 s or more"
set yrange [0:100.5]
set xlabel "alarms in calm runs [%]"
plot for [i = 1:words(index_names)] "curves.csv" \
         using (share("false_alarm_share", word(index_names, i))):(share("warned_200ms_share", word(index_names, i))) \
         with lines linewidth 2 dashtype dash_of(i) linecolor rgb colour_of(i), \
     "+" every ::::0 using (100 * warning_false_alarm_share):(100 * warning_warned_200ms_share) \
         with points pointtype 7 pointsize 1.6 linecolor rgb black
unset multiplot
