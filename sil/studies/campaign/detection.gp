# Detection against false alarms while the threshold moves: as the wheels lift, 0.1 s and 0.2 s before.
width = 1150
height = 1650
load scripts."/picture_style.gp"
load scripts."/index_style.gp"
load "report.gp"

share(name, wanted) = strcol("index") eq wanted ? 100 * column(name) : NaN

# The axis holds the firmware's warning, and an index that needs more alarms is said to do so.
most_alarms = larger(5, ceil(105 * warning_false_alarm_share))
array titles[words(index_names)]
do for [i = 1:words(index_names)] {
    stats "curves.csv" using (share("false_alarm_share", word(index_names, i))) name "ALARMS" nooutput
    titles[i] = word(index_names, i).(ALARMS_min <= most_alarms ? "" : sprintf(" (from %.0f %%)", ALARMS_min))
}

set xrange [0:most_alarms]
set yrange [0:100.5]
set ylabel "two-wheel lift-offs warned of [%]"
set rmargin at screen 0.77
set key at screen 0.785, graph 1 left top Left reverse noenhanced samplen 2.5 spacing 1.15
set multiplot layout 3,1 title sprintf("%d runs, %d two-wheel lift-offs, %d calm runs", \
    runs, lifted_runs, calm_runs) font ",13"
column_names = "warned_share warned_100ms_share warned_200ms_share"
array headings[3] = ["in force with the right side as the wheels lift", "for 0.1 s or more", "for 0.2 s or more"]
array warned[3] = [warning_warned_share, warning_warned_100ms_share, warning_warned_200ms_share]
do for [panel = 1:3] {
    set title headings[panel]
    if (panel == 2) { unset key }
    if (panel == 3) { set xlabel "alarms in calm runs [%]" }
    plot for [i = 1:words(index_names)] "curves.csv" \
             using (share("false_alarm_share", word(index_names, i))):(share(word(column_names, panel), word(index_names, i))) \
             with lines linewidth 2 dashtype index_dash(word(index_names, i)) linecolor rgb index_colour(word(index_names, i)) \
             title titles[i], \
         "+" every ::::0 using (100 * warning_false_alarm_share):(100 * warned[panel]) \
             with points pointtype 6 pointsize 2.5 linewidth 2.5 linecolor rgb black title "the firmware's warning"
}
unset multiplot
