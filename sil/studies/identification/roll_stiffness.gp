# Roll moment over roll angle: what the drives show once damping, inertia and offsets are taken off, and the curve.
width = 900
height = 640
load style
load "fit.gp"
set key left top Left reverse samplen 2 noenhanced
set xlabel "Roll angle [deg]"
set ylabel "Roll moment of the suspension [kN m]"
set arrow from first reach_deg, graph 0 to first reach_deg, graph 1 nohead dashtype "-" linecolor rgb grey
set arrow from first -reach_deg, graph 0 to first -reach_deg, graph 1 nohead dashtype "-" linecolor rgb grey
plot "fit.csv" using (column("dynamic") == 1 ? column("roll_angle_deg") : NaN):(column("static_moment_nm") / 1000) \
         with points pointtype 7 pointsize 0.25 linecolor rgb orange title "dynamic drives", \
     "fit.csv" using (column("dynamic") == 0 ? column("roll_angle_deg") : NaN):(column("static_moment_nm") / 1000) \
         with points pointtype 7 pointsize 0.25 linecolor rgb sky_blue title "slow ramps", \
     "curve.csv" using "roll_angle_deg":(column("moment_nm") / 1000) with lines linewidth 2 linecolor rgb blue \
         title "M(phi) fitted", \
     "curve.csv" using "roll_angle_deg":(column("linear_moment_nm") / 1000) with lines linewidth 1.5 dashtype 2 \
         linecolor rgb black title "K_f phi", \
     NaN with lines dashtype "-" linecolor rgb grey title "reach of the ramps"
