# Measured values, one panel each. Expects: scripts (folder of picture_style.gp), measured, panels, and for each number
# from 1 to panels name_N, unit_N, and choices_N: texts of its numbers from 0 on, separated by spaces, or "".
width = 1000
height = 50 + 170 * panels
load scripts."/picture_style.gp"
set datafile separator comma

choices(n) = value(sprintf("choices_%d", n))
label(n) = value(sprintf("name_%d", n)).((strlen(value(sprintf("unit_%d", n))) > 0) ? " [".value(sprintf("unit_%d", n))."]" : "")
height_of_panel = (1.0 - 50.0 / height) / panels

set multiplot
set lmargin at screen 0.17
set rmargin at screen 0.97
unset key
stats measured using 1 name "TIME" nooutput
set xrange [TIME_min:(TIME_max > TIME_min) ? TIME_max : TIME_min + 1]
do for [n = 1:panels] {
    set tmargin at screen 1.0 - (n - 1) * height_of_panel - 24.0 / height
    set bmargin at screen 1.0 - n * height_of_panel
    set format x (n == panels) ? "%g" : ""
    set xlabel (n == panels) ? "Time [s]" : ""
    unset ytics
    set title label(n) noenhanced offset 0,-0.8
    count = words(choices(n))
    if (count > 0) {
        set yrange [-0.4:count - 0.6]
        set ytics ("" 0)
        do for [choice = 1:count] {
            set ytics add (word(choices(n), choice) choice - 1) noenhanced
        }
        plot measured using 1:n + 1 with steps linewidth 2 linecolor rgb vermilion
    } else {
        set ytics auto
        set yrange [*:*]
        plot measured using 1:n + 1 with lines linewidth 2 linecolor rgb blue
    }
}
unset multiplot
