# Fig. 14: the RSI beside the load transfer ratio. Expects: run and default (folders), one_s, two_s, output_file.
format = "png"
width = 1000
height = 400
load scripts."/picture_style.gp"
load scripts."/index_style.gp"
set title "Normalised RSI and load transfer ratio, fishhook 1a" font ",12"
set xrange [1.9:3.9]
set yrange [0:1.25]
set xlabel "Time [s]"
set key outside right top Left reverse samplen 2 spacing 1.2
set arrow 1 from first one_s, graph 0 to first one_s, graph 1 nohead linewidth 1.5 dashtype one_wheel_dash linecolor rgb one_wheel_colour
set arrow 2 from first two_s, graph 0 to first two_s, graph 1 nohead linewidth 1.5 dashtype two_wheel_dash linecolor rgb two_wheel_colour
data = run."/firmware.csv"
plot data using "time_s":(abs(column("true_load_transfer_ratio"))) with lines linewidth 2 linecolor rgb index_colour("true_load_transfer") title "|LTR|, (26)", \
     data using "time_s":"level_published" with lines linewidth 2 dashtype index_dash("published") linecolor rgb index_colour("published") title "RSI, (25)", \
     default."/firmware.csv" using "time_s":"level_predicted_load_transfer" with lines linewidth 2 linecolor rgb index_colour("predicted_load_transfer") title "predicted |LTR|", \
     keyentry with lines linewidth 1.5 dashtype one_wheel_dash linecolor rgb one_wheel_colour title "one wheel lifts", \
     keyentry with lines linewidth 1.5 dashtype two_wheel_dash linecolor rgb two_wheel_colour title "two wheels lift"
unset output
