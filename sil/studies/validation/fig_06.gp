# Fig. 6: estimated and true movements of the roll centre. Expects: folder, nominal_m, lever_m, output_file.
format = "png"
width = 1000
height = 470
load scripts."/picture_style.gp"
published = folder."/j-turn-45-published/"
second = folder."/j-turn-45-default/"
set multiplot layout 1,2 title "Movement of the roll centre, J-turn at 45 km/h" font ",12" \
    margins 0.075,0.985,0.3,0.91 spacing 0.09,0.1
set xrange [0.5:10]
set xlabel "Time [s]"
set key at graph 0.5, graph -0.22 center top horizontal maxcols 2 Left reverse samplen 2
mm(name) = 1000 * column(name)
set ylabel "vertical, dh [mm]"
plot published."signals.csv" using "time_s":(1000 * (column("true_roll_centre_height_m") - nominal_m)) with lines linewidth 3 linecolor rgb black title "true, (24)", \
     published."firmware.csv" using "time_s":(mm("roll_centre_vertical_m")) with lines linewidth 2 dashtype 2 linecolor rgb vermilion title "published estimator", \
     second."firmware.csv" using "time_s":(mm("roll_centre_vertical_m")) with lines linewidth 2 linecolor rgb blue title "second estimator", \
     published."firmware.csv" using "time_s":(1000 * (column("true_kinematic_roll_centre_height_m") - kinematic_rest_m)) with lines linewidth 1.5 dashtype 4 linecolor rgb green title "kinematic"
set ylabel "lateral, c_{rc} [mm]"
plot published."signals.csv" using "time_s":(mm("true_roll_centre_lateral_m")) with lines linewidth 1.5 dashtype 4 linecolor rgb green title "kinematic", \
     published."firmware.csv" using "time_s":(mm("roll_centre_lateral_m")) with lines linewidth 2 dashtype 2 linecolor rgb vermilion title "(6), published estimator", \
     second."firmware.csv" using "time_s":(mm("roll_centre_lateral_m")) with lines linewidth 2 linecolor rgb blue title "(6), second estimator"
unset multiplot
unset output
