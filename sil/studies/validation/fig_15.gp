# Fig. 15: phase planes of the fishhook with the moments at which each index says "warn". Expects: run (folder), marks,
# turn_s (when the counter-steer's turn begins), output_file.
format = "png"
width = 1000
height = 520
load scripts."/picture_style.gp"
load scripts."/index_style.gp"
data = run."/signals.csv"
cell(n, place) = system(sprintf("sed -n '%dp' '%s' | cut -d , -f %d", n + 2, marks, place))
colour_of(what) = what eq "one_wheel" ? one_wheel_colour : what eq "two_wheels" ? two_wheel_colour : index_colour(what)
set multiplot layout 1,2 title "Fishhook 1a, counter-steer: when each index says \"warn\" (a right turn: everything is negative)" font ",12" \
    margins 0.075,0.985,0.24,0.9 spacing 0.1,0.1
stats marks using 2 nooutput name "M"
set key at screen 0.52, screen 0.11 center center horizontal maxcols 4 Left reverse samplen 1 spacing 1.1 width 2
set xlabel "Roll angle [deg]"
set xrange [-9.5:-3]
shown(value) = (column("time_s") >= turn_s - 0.2) ? value : NaN
set ylabel "Roll rate [deg/s]"
set yrange [-45:0]
plot data using (shown(column("true_roll_angle_deg"))):"true_roll_rate_degps" with lines linewidth 2 linecolor rgb grey notitle, \
     for [n = 0:M_records - 1] marks using 3:4 every ::n::n with points pointtype (n % 8 + 4) pointsize 1.7 linewidth 2 \
         linecolor rgb colour_of(cell(n, 6)) title cell(n, 1)
set ylabel "Lateral acceleration [g]"
set yrange [-1:-0.5]
plot data using (shown(column("true_roll_angle_deg"))):(in_g("true_lateral_acceleration_mps2")) with lines linewidth 2 linecolor rgb grey notitle, \
     for [n = 0:M_records - 1] marks using 3:5 every ::n::n with points pointtype (n % 8 + 4) pointsize 1.7 linewidth 2 \
         linecolor rgb colour_of(cell(n, 6)) notitle
unset multiplot
unset output
