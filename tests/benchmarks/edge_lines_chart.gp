# Draws what bench_edge_lines --chart wrote: milliseconds a frame against triangles, while the eye moves around a rigid
# mesh and while the mesh deforms.
#   gnuplot -e "sweep='edge_lines.csv'; picture='edge_lines.svg'" edge_lines_chart.gp        (a .png works, too)

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1100, 560 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1100, 560 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","

rows(panel, series) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' %s", panel, series, sweep)

# Both axes are logarithmic: a tenth of the cost is the same distance everywhere.
set logscale xy
set xrange [700:2300000]
set yrange [0.0005:600]
set xtics ("1k" 1000, "10k" 10000, "100k" 100000, "1M" 1000000)
set ytics (0.001, 0.01, 0.1, 1, 10, 100)
set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid xtics ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid
set key top left reverse Left samplen 1.6 spacing 1.1 textcolor "#303030"
set xlabel "triangles" textcolor "#606060"

set linetype 1 linecolor "#e0752d" linewidth 2.2 pointtype 7 pointsize 0.7
set linetype 2 linecolor "#1f5fa8" linewidth 2.2 pointtype 5 pointsize 0.7
set linetype 3 linecolor "#f0b48c" linewidth 2.2 pointtype 6 pointsize 0.7
set linetype 4 linecolor "#9a9a9a" linewidth 1.4 pointtype 0 dashtype (6, 4)

set multiplot layout 1, 2 margins 0.06, 0.99, 0.115, 0.82 spacing 0.07, 0.1
set label 1 "Finding the silhouettes of a mesh: all edges, or the tree" \
  at screen 0.012, 0.955 font ",17" textcolor "#202020"
set label 2 "milliseconds a frame on an irregular torus; the eye turns by a degree from each frame to the next" \
  at screen 0.012, 0.9 textcolor "#606060"

set title "{/:Bold a mesh that keeps its shape, one thread}" offset 0, -0.5 textcolor "#202020"
plot rows("rigid", "loop") using 3:4 with linespoints linetype 1 title "plain loop over faces and edges", \
     rows("rigid", "faces") using 3:4 with linespoints linetype 3 title "plain loop over faces alone", \
     rows("rigid", "loop") using 3:($4 / 10) with lines linetype 4 title "a tenth of the plain loop", \
     rows("rigid", "tree") using 3:4 with linespoints linetype 2 title "tree"
unset label
set title "{/:Bold a mesh that deforms: planes again, then}" offset 0, -0.5 textcolor "#202020"
plot rows("deforming", "loop") using 3:4 with linespoints linetype 1 title "loop, one thread", \
     rows("deforming", "parallel") using 3:4 with linespoints linetype 3 title "loop, all threads", \
     rows("deforming", "refit") using 3:4 with linespoints linetype 2 title "tree refitted, all threads"
unset multiplot
