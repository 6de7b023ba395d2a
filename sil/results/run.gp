# The run over time: five panels with one time axis, vertical lines at the events.
width = 1100
height = 1240
load scripts."/picture_style.gp"
load scripts."/index_style.gp"
load "events.gp"

# After two-wheel lift-off the vehicle is lost: the picture ends soon after, so that the moments before it have room.
time_end = happened(two_wheel_lift_time_s) ? smaller(end_time_s, two_wheel_lift_time_s + 0.8) : end_time_s
time_end = (time_end > 0) ? time_end : 1
set xrange [0:time_end]

# Extremes within the picture (stats looks at nothing outside the ranges that are set).
stats data using "time_s":"true_steering_wheel_angle_deg" name "STEER" nooutput
stats data using "time_s":(in_g("true_lateral_acceleration_mps2")) name "AY" nooutput
stats data using "time_s":"true_roll_angle_deg" name "ROLL" nooutput
stats data using "time_s":"true_roll_rate_degps" name "RATE" nooutput

left_edge = 0.085
right_edge = 0.725
panel_top(n) = 0.945 - 0.181 * n
panel_bottom(n) = panel_top(n) - 0.160
key_left = 0.805

set multiplot
set autoscale noextend
set lmargin at screen left_edge
set rmargin at screen right_edge
set key Left reverse at screen key_left, graph 1 left top samplen 2 spacing 1.25 noenhanced

if (happened(warning_time_s)) {
    set arrow from first warning_time_s, graph 0 to first warning_time_s, graph 1 nohead front \
        linewidth 1.8 linecolor rgb warning_colour
}
if (happened(one_wheel_lift_time_s)) {
    set arrow from first one_wheel_lift_time_s, graph 0 to first one_wheel_lift_time_s, graph 1 nohead front \
        linewidth 1.8 dashtype one_wheel_dash linecolor rgb one_wheel_colour
}
if (happened(two_wheel_lift_time_s)) {
    set arrow from first two_wheel_lift_time_s, graph 0 to first two_wheel_lift_time_s, graph 1 nohead front \
        linewidth 1.8 dashtype two_wheel_dash linecolor rgb two_wheel_colour
}
if (happened(ssf_crossing_time_s)) {
    set arrow from first ssf_crossing_time_s, graph 0 to first ssf_crossing_time_s, graph 1 nohead front \
        linewidth 1.8 dashtype ssf_dash linecolor rgb ssf_colour
}
event_title(name, time) = happened(time) ? sprintf("%s: %.3f s", name, time) : name.": never"

# 1: what the driver does, and the names of the vertical lines
set tmargin at screen panel_top(0)
set bmargin at screen panel_bottom(0)
set format x ""
set label 1 title_text at screen left_edge, screen 0.968 left noenhanced font ",13"
set ylabel "Steering wheel [deg]" offset 0.5
margin = larger(0.08 * (STEER_max_y - STEER_min_y), 5)
set yrange [STEER_min_y - margin:STEER_max_y + margin]
plot data using "time_s":"true_steering_wheel_angle_deg" with lines linewidth 2 linecolor rgb blue \
         title "steering wheel angle", \
     keyentry with lines linewidth 1.8 linecolor rgb warning_colour \
         title event_title("warning", warning_time_s), \
     keyentry with lines linewidth 1.8 dashtype one_wheel_dash linecolor rgb one_wheel_colour \
         title event_title("one wheel lifts", one_wheel_lift_time_s), \
     keyentry with lines linewidth 1.8 dashtype two_wheel_dash linecolor rgb two_wheel_colour \
         title event_title("two wheels lift", two_wheel_lift_time_s), \
     keyentry with lines linewidth 1.8 dashtype ssf_dash linecolor rgb ssf_colour \
         title event_title("SSF crossed", ssf_crossing_time_s)
unset label 1

# 2: lateral acceleration and the thresholds. The thresholds of the side that is not in danger are left out.
reaches_left = (AY_max_y > 0.2)
reaches_right = (AY_min_y < -0.2)
set yrange [(reaches_right ? -1.2 * larger(ssf, -AY_min_y) : -0.2):(reaches_left ? 1.2 * larger(ssf, AY_max_y) : 0.2)]
set tmargin at screen panel_top(1)
set bmargin at screen panel_bottom(1)
set ylabel "Lateral acceleration [g]"
plot data using "time_s":(in_g("sensor_lateral_acceleration_mps2")) with lines linewidth 1 linecolor rgb sky_blue \
         title "sensor (body axes)", \
     data using "time_s":(in_g("true_lateral_acceleration_mps2")) with lines linewidth 2 linecolor rgb blue \
         title "a_y, true", \
     data using "time_s":(threshold_in_g(0)) with lines linewidth 2 \
         dashtype 2 linecolor rgb vermilion title "RSI threshold a_y*", \
     (reaches_left || !reaches_right ? ssf : NaN) with lines linewidth 1.8 dashtype ssf_dash linecolor rgb ssf_colour \
         title "SSF", \
     (reaches_right ? -ssf : NaN) with lines linewidth 1.8 dashtype ssf_dash linecolor rgb ssf_colour notitle
set yrange [*:*]

# 3: roll angle and rate
set tmargin at screen panel_top(2)
set bmargin at screen panel_bottom(2)
set ylabel "Roll angle [deg]"
margin = larger(0.08 * (ROLL_max_y - ROLL_min_y), 0.7)
set yrange [ROLL_min_y - margin:ROLL_max_y + margin]
set ytics nomirror
set y2tics nomirror
margin = larger(0.08 * (RATE_max_y - RATE_min_y), 0.5)
set y2range [RATE_min_y - margin:RATE_max_y + margin]
set y2label "Roll rate [deg/s]" offset -0.5
plot data using "time_s":"true_roll_rate_degps" axes x1y2 with lines linewidth 1.5 dashtype 2 linecolor rgb orange \
         title "roll rate (right axis)", \
     data using "time_s":"sensor_roll_angle_deg" with lines linewidth 1 linecolor rgb sky_blue title "angle, sensor", \
     data using "time_s":"true_roll_angle_deg" with lines linewidth 2 linecolor rgb blue title "angle, true"

# 4: what the ECU says
set tmargin at screen panel_top(3)
set bmargin at screen panel_bottom(3)
set ylabel "Level"
set yrange [0:1.3]
set y2range [-0.25:3.25]
set y2tics ("unavailable" 0, "ready" 1, "advisory" 2, "warning" 3)
unset y2label
plot data using "time_s":"ecu_state_number" axes x1y2 with steps linewidth 2 linecolor rgb orange \
         title "state (right axis)", \
     data using "time_s":"ecu_warning_level" with lines linewidth 2 linecolor rgb blue \
         title "warning level", \
     data using "time_s":"ecu_rsi" with lines linewidth 1 dashtype index_dash("published") linecolor rgb index_colour("published") \
         title "RSI as published", \
     1 with lines linewidth 1.5 dashtype "-" linecolor rgb grey title "level 1"
unset y2tics
set y2range [*:*]

# 5: wheel loads
set tmargin at screen panel_top(4)
set bmargin at screen panel_bottom(4)
set yrange [0:*]
set offsets 0, 0, graph 0.05, 0
set format x "%g"
set xlabel "Time [s]"
set ylabel "Wheel load [kN]"
plot data using "time_s":(column("true_wheel_load_front_left_n") / 1000) with lines linewidth 2 \
         linecolor rgb blue title "front left", \
     data using "time_s":(column("true_wheel_load_front_right_n") / 1000) with lines linewidth 2 \
         linecolor rgb vermilion title "front right", \
     data using "time_s":(column("true_wheel_load_rear_left_n") / 1000) with lines linewidth 2 dashtype 2 \
         linecolor rgb sky_blue title "rear left", \
     data using "time_s":(column("true_wheel_load_rear_right_n") / 1000) with lines linewidth 2 dashtype 2 \
         linecolor rgb orange title "rear right"
unset multiplot
unset output
