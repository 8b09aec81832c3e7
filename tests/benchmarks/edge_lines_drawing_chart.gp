# Draws what bench_edge_lines_drawing --chart wrote: fidelity against cost, and what is lost while the eye moves.
#   gnuplot -e "sweep='edge_lines_drawing.csv'; picture='edge_lines_drawing.svg'" edge_lines_drawing_chart.gp

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1100, 480 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1100, 480 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","
rows(panel, method) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' %s", panel, method, sweep)

set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid xtics ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid
set linetype 1 linecolor "#1f5fa8" linewidth 2.2 pointtype 7 pointsize 1.2
set linetype 2 linecolor "#2f8f4e" linewidth 2.2 pointtype 5 pointsize 1.2
set linetype 3 linecolor "#e0752d" linewidth 2.2 pointtype 9 pointsize 1.4

set multiplot layout 1, 2 margins 0.075, 0.985, 0.125, 0.78 spacing 0.09, 0.1
set label 1 "Edge lines a pixel wide, bunny at 1024x768" at screen 0.012, 0.945 font ",17" textcolor "#202020"
set label 2 "against the mesh's lines clipped in double precision; depth: probes of the depth buffer, exact: clipped on the CPU, image: from differences of pixels" \
  at screen 0.012, 0.885 textcolor "#606060"

set title "{/:Bold farther than a pixel from each other, against cost}" offset 0, -0.5 textcolor "#202020"
set logscale y
set yrange [5e-6:1]
set ytics ("none" 1e-5, "0.01 %%" 1e-4, "0.1 %%" 1e-3, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
set xrange [0:*]
set offsets 0, graph 0.2, 0, 0 # for names at the right
set xlabel "time added to a frame, over the frame without lines" textcolor "#606060"
unset key
plot for [i = 1:3] rows("cost", word("depth exact image", i)) using 3:4 with points linetype i, \
     for [i = 1:3] rows("cost", word("depth exact image", i)) using 3:4:(sprintf("  %s", strcol(2))) with labels left offset 0.4, 0.4 textcolor "#303030" notitle

unset label
unset offsets
set title "{/:Bold lost length while the eye moves by 1/16 pixel a frame}" offset 0, -0.5 textcolor "#202020"
set yrange [0.03:*]
set ytics ("none" 0.05, "0.1" 0.1, "1" 1, "10" 10, "100" 100, "1000" 1000)
set xrange [0:2]
set xlabel "pixels moved" textcolor "#606060"
set ylabel "pixels of line without a drawn pixel within 1" textcolor "#606060"
set key top right textcolor "#303030"
plot for [i = 1:3] rows("steps", word("depth exact image", i)) using 3:4 with lines linetype i title word("depth exact image", i)
unset multiplot
