# A replayed drive over time: four panels with one time axis, vertical lines at the events.
width = 1100
height = 1000
load scripts."/picture_style.gp"
load scripts."/index_style.gp"
load "events.gp"
data = "indices.csv"

# gnuplot refuses a column without any value, and a drive may lack every signal but a few: such a column is drawn
# out of sight.
far_away = -1.0e6
has(name) = int(system("awk -F, -v name=".name." 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; next } c && $c != \"\" { found = 1; exit } END { print found + 0 }' indices.csv"))
shown(has_values, name) = has_values ? column(name) : far_away
has_sensor_ay = has("sensor_lateral_acceleration_mps2")
has_ay = has("lateral_acceleration_mps2")
has_threshold = has("lateral_acceleration_threshold_mps2")
has_roll = has("sensor_roll_angle_deg")
has_fixed_roll = has("fixed_model_roll_angle_deg")
has_compensated_roll = has("compensated_roll_angle_deg")
has_ltr = has("measured_load_transfer_ratio")
has_bank_free = has("rsi_bank_free")
has_rsi = has("rsi")
has_level = has("warning_level")
titled(has_values, name) = has_values ? name : name.": none"

stats data using "time_s":(1) name "TIME" nooutput
time_end = happened(two_wheel_lift_time_s) ? smaller(end_time_s, two_wheel_lift_time_s + 0.8) : end_time_s
time_start = TIME_min_x
time_end = (time_end > time_start) ? time_end : time_start + 1
set xrange [time_start:time_end]

left_edge = 0.085
right_edge = 0.725
panel_top(n) = 0.935 - 0.222 * n
panel_bottom(n) = panel_top(n) - 0.195
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
event_title(name, time) = happened(time) ? sprintf("%s: %.3f s", name, time) : name.": -"


# 1: lateral acceleration against its threshold
set tmargin at screen panel_top(0)
set bmargin at screen panel_bottom(0)
set format x ""
set label 1 title_text at screen left_edge, screen 0.965 left noenhanced font ",13"
set ylabel "Lateral acceleration [g]" offset 0.5
set yrange [-1.5:1.5]
plot data using "time_s":(shown(has_sensor_ay, "sensor_lateral_acceleration_mps2") / standard_gravity) with lines linewidth 1 linecolor rgb sky_blue \
         title titled(has_sensor_ay, "sensor (body axes)"), \
     data using "time_s":(shown(has_ay, "lateral_acceleration_mps2") / standard_gravity) with lines linewidth 2 linecolor rgb blue \
         title titled(has_ay, "a_y, measured"), \
     data using "time_s":(shown(has_threshold, "lateral_acceleration_threshold_mps2") / standard_gravity) with points pointtype 7 pointsize 0.2 linecolor rgb vermilion \
         title titled(has_threshold, "RSI threshold a_y*"), \
     keyentry with lines linewidth 1.8 linecolor rgb warning_colour \
         title event_title("warning", warning_time_s), \
     keyentry with lines linewidth 1.8 dashtype one_wheel_dash linecolor rgb one_wheel_colour \
         title event_title("one wheel lifts", one_wheel_lift_time_s), \
     keyentry with lines linewidth 1.8 dashtype two_wheel_dash linecolor rgb two_wheel_colour \
         title event_title("two wheels lift", two_wheel_lift_time_s)
unset label 1

# 2: roll angle, measured and modelled
set tmargin at screen panel_top(1)
set bmargin at screen panel_bottom(1)
set ylabel "Roll angle [deg]"
# Within the picture (stats looks at nothing outside the ranges that are set).
set yrange [*:*]
lowest_roll = -1.0
highest_roll = 1.0
if (has_roll) { stats data using "time_s":"sensor_roll_angle_deg" name "ROLL" nooutput; \
                lowest_roll = smaller(lowest_roll, ROLL_min_y); highest_roll = larger(highest_roll, ROLL_max_y) }
if (has_compensated_roll) { stats data using "time_s":"compensated_roll_angle_deg" name "MODEL" nooutput; \
                lowest_roll = smaller(lowest_roll, MODEL_min_y); highest_roll = larger(highest_roll, MODEL_max_y) }
roll_margin = 0.08 * (highest_roll - lowest_roll)
set yrange [lowest_roll - roll_margin:highest_roll + roll_margin]
plot data using "time_s":(shown(has_roll, "sensor_roll_angle_deg")) with lines linewidth 2 \
         linecolor rgb sky_blue title titled(has_roll, "sensor"), \
     data using "time_s":(shown(has_fixed_roll, "fixed_model_roll_angle_deg")) with lines linewidth 1.5 dashtype 2 \
         linecolor rgb orange title titled(has_fixed_roll, "fixed roll centre"), \
     data using "time_s":(shown(has_compensated_roll, "compensated_roll_angle_deg")) with lines linewidth 1.5 \
         linecolor rgb green title titled(has_compensated_roll, "compensated")

# 3: load transfer and the level that warns
set tmargin at screen panel_top(2)
set bmargin at screen panel_bottom(2)
set ylabel "Level, |LTR|"
set yrange [0:1.5]
plot data using "time_s":(has_ltr ? abs(column("measured_load_transfer_ratio")) : far_away) with lines linewidth 1.5 \
         linecolor rgb index_colour("true_load_transfer") title titled(has_ltr, "|LTR|, wheel loads"), \
     data using "time_s":(shown(has_bank_free, "rsi_bank_free")) with lines linewidth 1.5 dashtype index_dash("bank_free") linecolor rgb index_colour("bank_free") \
         title titled(has_bank_free, "RSI, bank-free"), \
     data using "time_s":(shown(has_rsi, "rsi")) with lines linewidth 1.5 dashtype index_dash("published") linecolor rgb index_colour("published") \
         title titled(has_rsi, "RSI"), \
     data using "time_s":(shown(has_level, "warning_level")) with lines linewidth 2 linecolor rgb index_colour("predicted_load_transfer") \
         title titled(has_level, "level that warns"), \
     1 with lines linewidth 1.5 dashtype "-" linecolor rgb grey notitle

# 4: what the ECU says
set tmargin at screen panel_top(3)
set bmargin at screen panel_bottom(3)
set ylabel "State" offset 3.5
set format x "%g"
set xlabel "Time [s]"
set yrange [-0.25:3.25]
set ytics ("unavailable" 0, "ready" 1, "advisory" 2, "warning" 3)
plot data using "time_s":"state_number" with steps linewidth 2 linecolor rgb orange title "state"
unset multiplot
unset output
