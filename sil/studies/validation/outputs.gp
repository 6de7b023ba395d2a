# Motion of the vehicle: handwheel, lateral acceleration, roll angle and roll rate over time, as Figs 5, 9, 11 and 13.
# Expects: run (folder), title_text, time_begin, time_end, one_s and two_s (NaN: never), banked (0 or 1), key_left and
# key_top (0 or 1: where the roll rate leaves room), output_file.
format = "png"
width = 1000
height = 620
load scripts."/picture_style.gp"
data = run."/signals.csv"
set xrange [time_begin:time_end]
set multiplot layout 2,2 title title_text font ",12" margins 0.075,0.985,0.09,0.93 spacing 0.085,0.1
if (happened(one_s)) { set arrow 1 from first one_s, graph 0 to first one_s, graph 1 nohead linewidth 1.5 dashtype one_wheel_dash linecolor rgb one_wheel_colour }
if (happened(two_s)) { set arrow 2 from first two_s, graph 0 to first two_s, graph 1 nohead linewidth 1.5 dashtype two_wheel_dash linecolor rgb two_wheel_colour }
set offsets 0, 0, graph 0.12, graph 0.05

set ylabel "Steering wheel [deg]"
plot data using "time_s":"true_steering_wheel_angle_deg" with lines linewidth 2 linecolor rgb blue notitle
set ylabel "Lateral acceleration [g]"
plot data using "time_s":(in_g("true_lateral_acceleration_mps2")) with lines linewidth 2 linecolor rgb blue notitle
set xlabel "Time [s]"
set ylabel "Roll angle [deg]"
set key top left Left reverse samplen 2
if (banked) {
    plot data using "time_s":"true_roll_angle_deg" with lines linewidth 2 linecolor rgb blue title "to the road", \
         data using "time_s":"true_roll_to_horizon_deg" with lines linewidth 2 dashtype 2 linecolor rgb vermilion title "to the horizon"
} else {
    plot data using "time_s":"true_roll_angle_deg" with lines linewidth 2 linecolor rgb blue notitle
}
set ylabel "Roll rate [deg/s]"
if (key_left && key_top) { set key left top } else { if (key_left) { set key left bottom } else { set key right top } }
plot data using "time_s":"true_roll_rate_degps" with lines linewidth 2 linecolor rgb blue notitle, \
     keyentry with lines linewidth 1.5 dashtype one_wheel_dash linecolor rgb one_wheel_colour \
         title (happened(one_s) ? sprintf("one wheel lifts, %.3f s", one_s) : "no wheel lifts"), \
     keyentry with lines linewidth 1.5 dashtype two_wheel_dash linecolor rgb two_wheel_colour \
         title (happened(two_s) ? sprintf("two wheels lift, %.3f s", two_s) : "two wheels lift: never")
unset multiplot
unset output
