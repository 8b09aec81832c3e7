# Draws what bench_gooch --chart wrote: the error of light per vertex, and the cost of the modes.
#   gnuplot -e "sweep='gooch.csv'; picture='gooch.svg'" gooch_chart.gp        (a .png works, too)

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1000, 460 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1000, 460 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","
rows(panel) = sprintf("< grep '^%s,' %s", panel, sweep)

set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid
set key top left reverse Left samplen 1.6 textcolor "#303030"

set multiplot
set label 1 "Light at the vertices, as in 1998, and per pixel" at screen 0.012, 0.945 font ",17" textcolor "#202020"

set lmargin at screen 0.095
set rmargin at screen 0.54
set bmargin at screen 0.13
set tmargin at screen 0.8
set title "{/:Bold greatest error of two lights per vertex}" offset 0, -0.3 textcolor "#202020"
set logscale xy
set xrange [4:75]
set yrange [0.0004:0.1]
set xtics (5, 7.5, 10, 15, 20, 30, 45, 60)
set ytics (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)
set xlabel "angle between the normals of neighbouring vertices, degrees" textcolor "#606060"
set ylabel "share of k_{warm} - k_{cool}" textcolor "#606060" offset 1, 0
set label 2 "1/255" at 4.2, 0.0045 textcolor "#909090"
plot rows("error") using 3:5 with lines linewidth 2.2 linecolor "#1f5fa8" title "(1 - cos(D/2))/2", \
     rows("error") using 3:4 with points pointtype 7 pointsize 0.8 linecolor "#e0752d" title "measured", \
     1.0/255 with lines linewidth 1 dashtype 2 linecolor "#909090" notitle
unset label

unset logscale
unset ylabel
unset ytics
set ytics autofreq nomirror scale 0.5 textcolor "#606060"
unset key
set lmargin at screen 0.73
set rmargin at screen 0.98
set title "{/:Bold frame time}" offset 0, -0.3 textcolor "#202020"
unset grid
set grid xtics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid
set xrange [0:1.3]
set yrange [4.6:-0.6]
set xtics 0, 0.25, 1.25
set xlabel "over that of the tones themselves" textcolor "#606060"
set style fill solid
plot rows("cost") using (0):3:(0):4:($3 - 0.3):($3 + 0.3):ytic(2) with boxxyerror linecolor "#8fb3dc", \
     rows("cost") using 4:3:(sprintf("%.2f", $4)) with labels left offset 0.6, 0 textcolor "#303030"
unset multiplot
