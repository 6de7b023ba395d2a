# Fig. 2: fixed against moving roll centre, the same input. Expects: folder, output_file.
format = "png"
width = 1000
height = 380
load scripts."/picture_style.gp"
fixed = folder."/roll-centre-fixed-published/signals.csv"
moving = folder."/roll-centre-moving-published/signals.csv"
set multiplot layout 1,2 title "Fixed against moving roll centre: J-turn at 68 km/h to 180 deg, large SUV" font ",12" \
    margins 0.07,0.985,0.14,0.89 spacing 0.09,0.1
set xrange [0.5:5]
set xlabel "Time [s]"
set key top left Left reverse samplen 2
set ylabel "Roll angle [deg]"
set yrange [-1:40]
plot moving using "time_s":"true_roll_angle_deg" with lines linewidth 2 linecolor rgb blue title "moving roll centre, stops", \
     fixed using "time_s":"true_roll_angle_deg" with lines linewidth 2 dashtype 2 linecolor rgb vermilion title "fixed roll centre, linear"
set ylabel "Roll rate [deg/s]"
set yrange [-20:80]
plot moving using "time_s":"true_roll_rate_degps" with lines linewidth 2 linecolor rgb blue title "moving roll centre, stops", \
     fixed using "time_s":"true_roll_rate_degps" with lines linewidth 2 dashtype 2 linecolor rgb vermilion title "fixed roll centre, linear"
unset multiplot
unset output
