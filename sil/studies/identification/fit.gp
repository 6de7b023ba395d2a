# Measured and fitted signals, all drives one after the other; grey lines where a drive begins.
width = 1100
height = 1000
load style
load "fit.gp"
panels = 2 + has_loads + has_steering
panel = 0
panel_height = 0.87 / panels
top(n) = 0.975 - n * panel_height
set multiplot
set lmargin at screen 0.085
set rmargin at screen 0.755
set xrange [0:end_s]
set key Left reverse at screen 0.765, graph 1 left top samplen 2 spacing 1.25 noenhanced
set format x ""
do for [start in drive_starts] {
    set arrow from first real(start), graph 0 to first real(start), graph 1 nohead linewidth 1.5 linecolor rgb grey
}

set tmargin at screen top(panel)
set bmargin at screen top(panel) - panel_height + 0.03
set ylabel "Moment [kN m]"
plot "fit.csv" using "running_time_s":(column("moment_nm") / 1000) with lines linewidth 2.5 linecolor rgb sky_blue \
         title "m_s H f, measured", \
     "" using "running_time_s":(column("fitted_moment_nm") / 1000) with lines linewidth 1.2 linecolor rgb blue \
         title "M + c p + Ixx p', fitted"

panel = panel + 1
set tmargin at screen top(panel)
set bmargin at screen top(panel) - panel_height + 0.03
set ylabel "Residual [kN m]"
if (panel == panels - 1) { set format x "%g"; set xlabel "Time, drives one after the other [s]" }
plot "fit.csv" using "running_time_s":(column("residual_nm") / 1000) with lines linewidth 1.2 linecolor rgb vermilion \
         title "measured - fitted"

if (has_loads) {
    panel = panel + 1
    set tmargin at screen top(panel)
    set bmargin at screen top(panel) - panel_height + 0.03
    if (panel == panels - 1) { set format x "%g"; set xlabel "Time, drives one after the other [s]" }
    set ylabel "Load moment [kN m]"
    plot "fit.csv" using "running_time_s":(column("load_moment_nm") / 1000) with lines linewidth 2.5 \
             linecolor rgb sky_blue title "wheel loads", \
         "" using "running_time_s":(column("fitted_load_moment_nm") / 1000) with lines linewidth 1.2 \
             linecolor rgb blue title "alpha A + M + c p"
}

if (has_steering) {
    panel = panel + 1
    set tmargin at screen top(panel)
    set bmargin at screen top(panel) - panel_height + 0.03
    set format x "%g"
    set xlabel "Time, drives one after the other [s]"
    set ylabel "Acceleration [m/s^2]"
    plot "fit.csv" using "running_time_s":"yaw_acceleration_mps2" with lines linewidth 2.5 linecolor rgb sky_blue \
             title "r V, measured", \
         "" using "running_time_s":"steering_acceleration_mps2" with lines linewidth 1.2 linecolor rgb blue \
             title "asked for by the steering"
}
unset multiplot
unset output
