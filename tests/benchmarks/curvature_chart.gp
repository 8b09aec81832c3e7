# Draws what bench_curvature --chart wrote: error against cost, above of curvatures, below of directions, for three
# amounts of noise.
#   gnuplot -e "sweep='curvature.csv'; picture='curvature.svg'" curvature_chart.gp        (a .png works, too)

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1180, 860 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1180, 860 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","

rows(noise, series) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' %s", noise, series, sweep)

# Both axes are logarithmic: the ratio of two costs, or of two errors, is the same distance everywhere.
set logscale xy
set xrange [0.1:200]
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)
set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)
set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid xtics ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid

set linetype 1 linecolor "#9a9a9a" linewidth 2.2 pointtype 7 pointsize 0.8
set linetype 2 linecolor "#e0752d" linewidth 2.2 pointtype 5 pointsize 0.7
set linetype 3 linecolor "#8fb3dc" linewidth 2.2 pointtype 7 pointsize 0.7
set linetype 4 linecolor "#1f5fa8" linewidth 2.4 pointtype 9 pointsize 1.6
set linetype 5 linecolor "#707070" linewidth 1.4 pointtype 6 pointsize 1.0

small = "font ',10' textcolor '#606060' notitle"

set multiplot layout 2, 3 margins 0.055, 0.99, 0.07, 0.86 spacing 0.045, 0.1
set label 1 "Principal curvatures of an irregular torus of 10k vertices: error against cost" \
  at screen 0.012, 0.965 font ",17" textcolor "#202020"
set label 2 "numbers at the points are rings of vertices; hollow: published for the same methods by rising cost (one ring; degree 2 on 2 rings; degree 4 on 3; degree 2 on 5)" \
  at screen 0.012, 0.925 textcolor "#606060"
do for [row = 1:2] {
  column = row == 1 ? 5 : 6
  set yrange [0.03:(row == 1 ? 150 : 60)]
  do for [i = 1:3] {
    noise = word("0 0.01 0.05", i)
    if (row == 1) {
      set title "{/:Bold ".(i == 1 ? "clean" : i == 2 ? "noise: 1 % of an edge" : "noise: 5 % of an edge")."}" \
        offset 0, -0.4 textcolor "#202020"
    } else { unset title }
    if (row == 2) { set xlabel "microseconds per vertex, one core" textcolor "#606060" } else { unset xlabel }
    if (i == 1) { set ylabel (row == 1 ? "RMS error of curvatures, %" : "error of directions, degrees (95th percentile)") offset 1.2, 0 textcolor "#606060" } else { unset ylabel }
    if (row == 1 && i == 1) { set key top right Left reverse samplen 1.6 spacing 1.1 textcolor "#303030" } else { unset key }
    plot rows(noise, "published") using 4:column with points linetype 5 title "published", \
         rows(noise, "one ring") using 4:column with points linetype 1 title "one ring", \
         rows(noise, "degree 2") using 4:column with linespoints linetype 2 title "degree 2", \
         rows(noise, "degree 4") using 4:column with linespoints linetype 3 title "degree 4", \
         rows(noise, "automatic") using 4:column with points linetype 4 title "automatic", \
         rows(noise, "degree 2") using 4:column:3 with labels left offset 0.6, 0.4 @small, \
         rows(noise, "degree 4") using 4:column:3 with labels right offset -0.6, -0.4 @small
    unset label
  }
}
unset multiplot
