# Style of all pictures: terminal, colours that colour-blind people can tell apart (Okabe and Ito), data format.
# Expects: format ("svg" or "png"), output_file, width and height in pixels.

if (format eq "svg") {
    set terminal svg size width, height dynamic enhanced font "DejaVu Sans,11" background "white"
} else {
    set terminal pngcairo size width, height enhanced font "DejaVu Sans,10"
}
set output output_file

black = "#000000"
grey = "#8c8c8c"
orange = "#e69f00"
sky_blue = "#56b4e9"
green = "#009e73"
blue = "#0072b2"
vermilion = "#d55e00"
purple = "#cc79a7"

# One style of line an event, the same in every picture.
warning_colour = vermilion
one_wheel_colour = orange
two_wheel_colour = black
ssf_colour = purple
one_wheel_dash = "_"
two_wheel_dash = "_. "
ssf_dash = "-"

data = "signals.csv"
set datafile separator comma
set datafile columnheaders
set encoding utf8

standard_gravity = 9.80665
# When the threshold changes sides (the ECU shows that of the present side) the line is broken.
threshold = NaN
previous_threshold = NaN
threshold_in_g(unused) = (previous_threshold = threshold, \
                    threshold = column("ecu_lateral_acceleration_threshold_mps2") / standard_gravity, \
                    previous_threshold * threshold < 0 ? NaN : threshold)
in_g(name) = column(name) / standard_gravity
happened(time) = (time == time)    # NaN differs from itself
larger(a, b) = (a > b) ? a : b
smaller(a, b) = (a < b) ? a : b

set border linecolor rgb grey
set tics textcolor rgb black nomirror
set grid linecolor rgb "#e4e4e4" linetype 1 linewidth 0.8
