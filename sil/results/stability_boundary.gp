# The stability boundary: roll angle over lateral acceleration, as Figs 8 and 10 of Jung, Shim and Gertsch (2009).
# Right of the RSI line (left of it in a right turn) is the region of rollover.
width = 900
height = 680
load scripts."/picture_style.gp"
load "events.gp"

stats data using "time_s":(in_g("true_lateral_acceleration_mps2")) name "AY" nooutput
stats data using "time_s":"true_roll_angle_deg" name "ROLL" nooutput
reaches_right = (AY_min_y < -0.2)
reaches_left = (AY_max_y > 0.2) || !reaches_right

# Beyond two-wheel lift-off the roll angle only grows: what matters lies below twice its value there.
rolls_over = happened(two_wheel_lift_roll_deg)
largest_roll = rolls_over ? 2 * larger(abs(two_wheel_lift_roll_deg), 4) : 1.25 * larger(ROLL_max_y, -ROLL_min_y)
largest_roll = larger(largest_roll, 1)
limit_ay = 1.25 * larger(ssf, smaller(larger(AY_max_y, -AY_min_y), 1.1 * ssf))

set xrange [(reaches_right ? -limit_ay : -0.05):(reaches_left ? limit_ay : 0.05)]
set yrange [(reaches_right ? -largest_roll : -0.04 * largest_roll):(reaches_left ? largest_roll : 0.04 * largest_roll)]

set title title_text noenhanced font ",12"
set xlabel "Lateral acceleration a_y [g]"
set ylabel "Roll angle relative to the road [deg]"
set key outside below center horizontal maxcols 3 Left reverse samplen 2 spacing 1.2
label_height = reaches_left ? 0.07 : 0.93
if (reaches_left) { set label "rollover" at (ssf + limit_ay) / 2, graph label_height center textcolor rgb grey }
if (reaches_right) { set label "rollover" at -(ssf + limit_ay) / 2, graph label_height center textcolor rgb grey }
set label "stable" at 0.5 * ((reaches_left ? ssf : 0) - (reaches_right ? ssf : 0)), graph label_height center textcolor rgb grey

event_title(name, time, ay, roll) = \
    happened(time) ? sprintf("%s: %.2f g, %.1f deg, %.3f s", name, ay, roll, time) : name.": never"

# Marks of the events, on the vehicle's way.
if (happened(warning_time_s)) {
    set label at warning_ay_g, warning_roll_deg point pointtype 5 pointsize 1.7 linecolor rgb warning_colour front
}
if (happened(one_wheel_lift_time_s)) {
    set label at one_wheel_lift_ay_g, one_wheel_lift_roll_deg \
        point pointtype 9 pointsize 1.9 linecolor rgb one_wheel_colour front
}
if (happened(two_wheel_lift_time_s)) {
    set label at two_wheel_lift_ay_g, two_wheel_lift_roll_deg \
        point pointtype 7 pointsize 1.7 linecolor rgb two_wheel_colour front
}
if (reaches_left) { set arrow from ssf, graph 0 to ssf, graph 1 nohead linewidth 2 dashtype ssf_dash linecolor rgb ssf_colour }
if (reaches_right) { set arrow from -ssf, graph 0 to -ssf, graph 1 nohead linewidth 2 dashtype ssf_dash linecolor rgb ssf_colour }

# The threshold is traced by the run: each row of the data gives a point (a_y*, roll).
plot data using (threshold_in_g(0)):"true_roll_angle_deg" with lines linewidth 2.5 \
         dashtype 2 linecolor rgb vermilion title "RSI threshold a_y*", \
     data using (in_g("true_lateral_acceleration_mps2")):"true_roll_angle_deg" with lines linewidth 2.5 \
         linecolor rgb blue title "vehicle", \
     keyentry with lines linewidth 2 dashtype ssf_dash linecolor rgb ssf_colour title sprintf("SSF %.3f g", ssf), \
     keyentry with points pointtype 5 pointsize 1.7 linecolor rgb warning_colour \
         title event_title("warning", warning_time_s, warning_ay_g, warning_roll_deg), \
     keyentry with points pointtype 9 pointsize 1.9 linecolor rgb one_wheel_colour \
         title event_title("one wheel lifts", one_wheel_lift_time_s, one_wheel_lift_ay_g, one_wheel_lift_roll_deg), \
     keyentry with points pointtype 7 pointsize 1.7 linecolor rgb two_wheel_colour \
         title event_title("two wheels lift", two_wheel_lift_time_s, two_wheel_lift_ay_g, two_wheel_lift_roll_deg)
unset output
