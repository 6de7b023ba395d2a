# One line a class of vehicles or a published value: from low to high, with the middle; the population's least and largest.
# Expects: rows, a file of tabs (place, outer low, low, middle, high, outer high, group, label), lines, least, largest, axis,
# logarithmic (0 or 1), lowest and highest of all numbers.
width = 1000
height = 100 + 17 * lines
load scripts."/picture_style.gp"
set datafile separator tab
unset datafile columnheaders
set datafile missing "-"

array colours[4] = [blue, orange, vermilion, black]
array names[4] = ["population", "commonroad", "jointed", "published"]
of_group(i, value) = column(7) == i ? value : NaN
is_limit(unused) = column(4) != column(4) && column(5) != column(5)  # no middle, no high: all above
set yrange [lines + 0.5:0.5]
set xlabel axis
if (logarithmic) {
    set logscale x
    set xrange [lowest / 1.2:highest * 1.2]
} else {
    margin = highest > lowest ? (highest - lowest) / 40 : 0.05 + abs(highest) / 20  # few vehicles may share one value
    set xrange [lowest - margin:highest + margin]
}
set ytics scale 0
set arrow from least, graph 0 to least, graph 1 nohead dashtype 2 linecolor rgb grey
set arrow from largest, graph 0 to largest, graph 1 nohead dashtype 2 linecolor rgb grey
set key above right Left reverse noenhanced samplen 1 width 2
plot for [i = 1:4] rows using 2:(of_group(i, column(1))):(column(6) - column(2)):(0) with vectors nohead linewidth 1 \
         linecolor rgb colours[i] notitle, \
     for [i = 1:4] rows using 3:(of_group(i, column(1))):(column(5) - column(3)):(0) with vectors nohead linewidth 5 \
         linecolor rgb colours[i] notitle, \
     for [i = 1:4] rows using 3:(of_group(i, column(1))) with points pointtype 7 pointsize 0.6 linecolor rgb colours[i] notitle, \
     for [i = 1:4] rows using 5:(of_group(i, column(1))) with points pointtype 7 pointsize 0.6 linecolor rgb colours[i] notitle, \
     for [i = 1:4] rows using 4:(of_group(i, column(1))) with points pointtype 7 pointsize 1.5 linecolor rgb "white" notitle, \
     for [i = 1:4] rows using 4:(of_group(i, column(1))) with points pointtype 7 pointsize 1.1 linecolor rgb colours[i] \
         title names[i], \
     rows using 3:(is_limit(0) ? column(1) : NaN):((largest - least) / 8):(0) with vectors head filled linewidth 1.5 \
         linecolor rgb black notitle, \
     rows using (NaN):1:ytic(8) notitle
