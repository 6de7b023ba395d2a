# Fig. 7: the simple model, the vehicle and the compensated models. Expects: folder, output_file.
format = "png"
width = 1000
height = 470
load scripts."/picture_style.gp"
published = folder."/j-turn-45-published/"
second = folder."/j-turn-45-default/"
set multiplot layout 1,2 title "Roll angle of the simple model, with and without compensation: J-turn at 45 km/h" font ",12" \
    margins 0.07,0.985,0.3,0.91 spacing 0.09,0.1
set xlabel "Time [s]"
set ylabel "Roll angle [deg]"
set key at graph 0.5, graph -0.22 center top horizontal maxcols 1 Left reverse samplen 2
do for [part = 1:2] {
    set xrange [(part == 1 ? 0.5 : 0.9):(part == 1 ? 10 : 2.8)]
    plot published."signals.csv" using "time_s":"true_roll_angle_deg" with lines linewidth 3.5 linecolor rgb grey title "vehicle", \
         published."firmware.csv" using "time_s":"fixed_model_roll_angle_deg" with lines linewidth 1.5 dashtype 4 linecolor rgb green title "simple model, (1)", \
         published."firmware.csv" using "time_s":"compensated_roll_angle_deg" with lines linewidth 2 dashtype 2 linecolor rgb vermilion title "compensated, published estimates", \
         second."firmware.csv" using "time_s":"compensated_roll_angle_deg" with lines linewidth 1.5 linecolor rgb blue title "compensated, second estimator"
}
unset multiplot
unset output
