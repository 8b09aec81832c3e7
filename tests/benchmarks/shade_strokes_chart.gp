# Draws what bench_shade_strokes --chart wrote: what strokes cost the CPU by what changes, and how exact they are for it.
#   gnuplot -e "sweep='shade_strokes.csv'; picture='shade_strokes.svg'" shade_strokes_chart.gp

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1200, 900 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1200, 900 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","
rows(panel, series) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' %s", panel, series, sweep)

set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid xtics ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid
set linetype 1 linecolor "#1f5fa8" linewidth 2 pointtype 7 pointsize 0.7
set linetype 2 linecolor "#2f8f4e" linewidth 2 pointtype 5 pointsize 0.7
set linetype 3 linecolor "#e0752d" linewidth 2 pointtype 9 pointsize 0.8

set multiplot layout 2, 2 margins 0.075, 0.965, 0.07, 0.86 spacing 0.1, 0.14
set label 1 "Shade strokes: what they cost the CPU, and how exact they are" at screen 0.012, 0.97 font ",17" textcolor "#202020"
set label 2 "bunny: 70 thousand triangles; torus: a million; 4000 cells and a dead band of .0025 where neither is varied" \
  at screen 0.012, 0.935 textcolor "#606060"
set label 3 "time: of the processor, all threads together; a frame: the light turns by a degree" at screen 0.012, 0.91 textcolor "#606060"
note = "textcolor '#606060' font ',11' notitle"
set key top left textcolor "#303030" samplen 2 spacing 1.1

set title "{/:Bold an update, by the cells whose shade changes by a tenth}" offset 0, -0.5 textcolor "#202020"
set xlabel "cells touched" textcolor "#606060"
set ylabel "ms" textcolor "#606060" offset 1, 0
set xrange [0:*]
set yrange [0:*]
plot for [i = 1:2] rows("touched", word("bunny torus", i)) using 4:5 with linespoints linetype i title word("bunny torus", i)

unset label
set title "{/:Bold dead band, bunny}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms a frame" textcolor "#606060"
set ylabel "mean |needed - delivered|" textcolor "#606060" offset 1, 0
plot rows("band", "a degree a frame") using 4:5 with linespoints linetype 1 notitle, \
     rows("band", "a degree a frame") using 4:5:3 with labels left offset 0.7, 0.5 @note

set title "{/:Bold number of cells, bunny}" offset 0, -0.5 textcolor "#202020"
set ylabel "mean |shade at a vertex - delivered|" textcolor "#606060" offset 1, 0
plot rows("cells", "a degree a frame") using 4:5 with linespoints linetype 1 notitle, \
     rows("cells", "a degree a frame") using 4:5:3 with labels left offset 0.7, 0.5 @note

set title "{/:Bold size of the mesh}" offset 0, -0.5 textcolor "#202020"
set xlabel "triangles" textcolor "#606060"
set ylabel "ms" textcolor "#606060" offset 1, 0
set logscale xy
set format x "%g"
set format y "%g"
set xrange [*:*]
set yrange [*:*]
plot rows("prepare", "mesh") using 4:5 with linespoints linetype 1 title "once by mesh", \
     rows("prepare", "strokes from nothing") using 4:5 with linespoints linetype 2 title "strokes from nothing", \
     rows("prepare", "a frame") using 4:5 with linespoints linetype 3 title "a degree of the light"
unset multiplot
