# Draws what bench_deform --chart wrote: error against cost, one panel for normals, one for principal directions.
#   gnuplot -e "sweep='deform.csv'; picture='deform.svg'" deform_chart.gp        (a .png works, too)

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1100, 560 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1100, 560 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","

rows(panel, series) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' %s", panel, series, sweep)

# The angle of each point of a method's two series: LBS on the left of its points, DQS on the right, so that where they
# fall together both can be read; the largest farther out, since its error is often that of the next.
angles(panel, method, degrees) = sprintf("< awk -F, '$1 == \"%s\" && index($2, \"%s\") == 1 && ($3 %s) {printf \"%%s,%%s,%%s\\n\", $4, $5, $3}' %s", panel, method, degrees, sweep)

# Both axes are logarithmic: the ratio of two costs, or of two errors, is the same distance everywhere.
set logscale xy
set xrange [0.001:1]
set yrange [0.01:100]
set xtics (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1)
set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50)
set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid xtics ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid
set key bottom left reverse Left samplen 1.6 spacing 1.1 textcolor "#303030"
set xlabel "microseconds per vertex, one core, all steps together" textcolor "#606060"

set linetype 1 linecolor "#e0752d" linewidth 2.2 pointtype 7 pointsize 0.7
set linetype 2 linecolor "#1f5fa8" linewidth 2.2 pointtype 5 pointsize 0.7
set linetype 3 linecolor "#f0b48c" linewidth 2.2 pointtype 6 pointsize 0.7
set linetype 4 linecolor "#8fb3dc" linewidth 2.2 pointtype 4 pointsize 0.7

small = "font ',10' textcolor '#606060' notitle"

set multiplot layout 1, 2 margins 0.06, 0.99, 0.115, 0.82 spacing 0.07, 0.1
set label 1 "A bent cylinder: what is blended or carried from rest, and what is recomputed" \
  at screen 0.012, 0.955 font ",17" textcolor "#202020"
set label 2 "RMS error in the joint zone in degrees against cost; from below 30, 60, 90 and 120 degrees of bend" \
  at screen 0.012, 0.9 textcolor "#606060"
do for [i = 1:2] {
  panel = word("normals directions", i)
  cheap = word("blended carried", i)
  set title "{/:Bold ".(i == 1 ? "normals" : "principal directions")."}" offset 0, -0.5 textcolor "#202020"
  plot rows(panel, "LBS ".cheap) using 4:5 with linespoints linetype 1 title "LBS ".cheap, \
       rows(panel, "DQS ".cheap) using 4:5 with linespoints linetype 2 title "DQS ".cheap, \
       rows(panel, "LBS recomputed") using 4:5 with linespoints linetype 3 title "LBS recomputed", \
       rows(panel, "DQS recomputed") using 4:5 with linespoints linetype 4 title "DQS recomputed", \
       angles(panel, "LBS", "< 120") using 1:2:(strcol(3)."°") with labels right offset -0.8, 0 @small, \
       angles(panel, "LBS", "== 120") using 1:2:(strcol(3)."°") with labels right offset -4.2, 0.1 @small, \
       angles(panel, "DQS", "< 120") using 1:2:(strcol(3)."°") with labels left offset 0.8, 0 @small, \
       angles(panel, "DQS", "== 120") using 1:2:(strcol(3)."°") with labels left offset 4.2, 0.1 @small
  unset label
}
unset multiplot
