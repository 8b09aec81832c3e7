# Draws what bench_implicit_brush --chart wrote: error against cost for the knobs of implicit brushes.
#   gnuplot -e "sweep='implicit_brush.csv'; picture='implicit_brush.svg'" implicit_brush_chart.gp

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1200, 1700 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1200, 1700 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
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
set linetype 4 linecolor "#8a4fa3" linewidth 2 pointtype 13 pointsize 0.8
set linetype 6 linecolor "#c2272d" linewidth 2 pointtype 6 pointsize 1.8

set multiplot layout 4, 2 margins 0.075, 0.965, 0.04, 0.915 spacing 0.1, 0.075
set label 1 "Implicit brushes: how far off they are, against time" at screen 0.012, 0.982 font ",17" textcolor "#202020"
set label 2 "features: lines of a ripple of 38 px from ring to ring, place over all pixels within 2 px of a line; a dotted line is the limit of .05 px" \
  at screen 0.012, 0.967 textcolor "#606060"
set label 3 "brushes: stamps of a drawn frame after tone mapping, against double precision; a dotted line is the limit of 1/255" \
  at screen 0.012, 0.955 textcolor "#606060"

place_limit(x) = 0.05
set logscale y
set format y "%g"
set ylabel "place, RMS, px" textcolor "#606060" offset 1, 0
set xlabel "ms by megapixel, profiles" textcolor "#606060"
set key top right textcolor "#303030" samplen 2 spacing 1.1
note = "textcolor '#606060' font ',11' notitle"
limit = "with lines dashtype 3 linecolor '#808080' linewidth 1 notitle"
set xrange [0:*]
set yrange [2e-3:4]
noises = "0 0.005 0.02"

set title "{/:Bold window of a profile, px, by noise of slopes}" offset 0, -0.5 textcolor "#202020"
plot place_limit(x) @limit, \
     for [i = 1:3] rows("window", "noise ".word(noises, i)) using 4:5 with linespoints linetype i title "noise ".word(noises, i), \
     for [i = 1:3] rows("window", "noise ".word(noises, i)) using 4:5:3 with labels left offset 0.7, 0.5 @note

unset label
set title "{/:Bold k, samples on either side: 2 3 4 6 8 12}" offset 0, -0.5 textcolor "#202020"
set yrange [2e-3:0.2]
plot place_limit(x) @limit, \
     for [i = 1:4] rows("taps", sprintf("%d fits", i)) using 4:5 with linespoints linetype i title (i == 1 ? "1 fit" : sprintf("%d fits", i)), \
     rows("taps", "preset") using 4:5 with points linetype 6 title "presets", \
     rows("taps", "preset") using 4:5:3 with labels left offset 1.2, 0.6 textcolor "#c2272d" notitle

set title "{/:Bold steps of diffusion, by noise of slopes}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel, diffusion" textcolor "#606060"
set yrange [2e-3:4]
plot place_limit(x) @limit, \
     for [i = 1:3] rows("diffusion", "noise ".word(noises, i)) using 4:5 with linespoints linetype i title "noise ".word(noises, i), \
     for [i = 1:3] rows("diffusion", "noise ".word(noises, i)) using 4:5:3 with labels left offset 0.7, 0.5 @note

set title "{/:Bold storage of slopes and features, bits of a number}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel, features in all" textcolor "#606060"
set yrange [2e-3:1]
kinds = "ridges inflections"
plot place_limit(x) @limit, \
     for [i = 1:2] rows("storage", word(kinds, i)) using 4:5 with linespoints linetype i title word(kinds, i), \
     for [i = 1:2] rows("storage", word(kinds, i)) using 4:5:3 with labels left offset 0.7, 0.5 @note

one(x) = 1.0
set ylabel "largest error, of 255" textcolor "#606060" offset 1, 0
set xlabel "ms by megapixel" textcolor "#606060"
set logscale x
set xrange [*:*]
set yrange [5e-5:20]
methods = "splat gather tiles sums"
set title "{/:Bold ways of adding up stamps of radius 1 to 32}" offset 0, -0.5 textcolor "#202020"
plot one(x) @limit, \
     for [i = 1:4] rows("radius", word(methods, i)) using 4:5 with linespoints linetype i title word(methods, i), \
     for [i = 1:4] rows("radius", word(methods, i)) using 4:5:3 with labels left offset 0.4, 0.7 @note

set title "{/:Bold storage of sums, splats of radius 1 to 32}" offset 0, -0.5 textcolor "#202020"
formats = "rgba16f rgba32f"
plot one(x) @limit, \
     for [i = 1:2] rows("sums", word(formats, i)) using 4:5 with linespoints linetype i title word(formats, i), \
     for [i = 1:2] rows("sums", word(formats, i)) using 4:5:3 with labels left offset 0.4, 0.7 @note

set title "{/:Bold least weight that stamps, splats of radius 10}" offset 0, -0.5 textcolor "#202020"
plot one(x) @limit, \
     rows("cutoff", "radius 10") using 4:5 with linespoints linetype 1 notitle, \
     rows("cutoff", "radius 10") using 4:5:3 with labels left offset 0.7, 0.4 @note
unset multiplot
