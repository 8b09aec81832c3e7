# Draws what bench_abstracted_lines --chart wrote: error against cost for the knobs of finding abstracted lines.
#   gnuplot -e "sweep='abstracted_lines.csv'; picture='abstracted_lines.svg'" abstracted_lines_chart.gp

if (picture[strlen(picture) - 2:] eq "png") {
  set terminal pngcairo size 1200, 1300 font "DejaVu Sans,10" background "white"
} else {
  set terminal svg size 1200, 1300 font "DejaVu Sans, Helvetica, sans-serif,13" background "white"
}
set output picture
set datafile separator ","
rows(panel, series) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' %s", panel, series, sweep)

labelled(panel, label) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"preset\" && $3 == \"%s\"' %s", panel, label, sweep)

set border 3 linecolor "#808080"
set tics nomirror scale 0.5 textcolor "#606060"
set grid xtics ytics linetype 2 linecolor "#e6e6e6" linewidth 1 dashtype solid
set linetype 1 linecolor "#1f5fa8" linewidth 2 pointtype 7 pointsize 0.7
set linetype 2 linecolor "#2f8f4e" linewidth 2 pointtype 5 pointsize 0.7
set linetype 3 linecolor "#e0752d" linewidth 2 pointtype 9 pointsize 0.8
set linetype 4 linecolor "#8a4fa3" linewidth 2 pointtype 13 pointsize 0.8
set linetype 5 linecolor "#707070" linewidth 2 pointtype 11 pointsize 0.8
set linetype 6 linecolor "#c2272d" linewidth 2 pointtype 6 pointsize 1.8

stats rows("beta", "ms") using 5 nooutput
set multiplot layout 3, 2 margins 0.075, 0.935, 0.05, 0.9 spacing 0.13, 0.1
set label 1 "Finding abstracted lines: how far off they are, against time" at screen 0.012, 0.975 font ",17" textcolor "#202020"
set label 2 "place: RMS over the pixels of bars at many angles and phases; a dotted line is the limit of .02 px" \
  at screen 0.012, 0.955 textcolor "#606060"
set label 3 "time: blur and lines of both channels, bunny at 1024x768, by megapixel that lines can be in; what is not varied is as in the standard" \
  at screen 0.012, 0.939 textcolor "#606060"

place_axis = "place, RMS, px"
limit(x) = 0.02
set logscale y
set format y "%g"
set ylabel place_axis textcolor "#606060" offset 1, 0
set key top right textcolor "#303030" samplen 2 spacing 1.1
name = "textcolor '#c2272d' notitle"
note = "textcolor '#606060' font ',11' notitle"

set title "{/:Bold taps, and 1 to 8 fits}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel" textcolor "#606060"
set xrange [0:*]
set yrange [1e-3:0.5]
plot limit(x) with lines dashtype 3 linecolor "#808080" linewidth 1 notitle, \
     rows("search", "square") using 4:5 with linespoints linetype 1 title "3 x 3", \
     rows("search", "weighted") using 4:5 with linespoints linetype 2 title "3 x 3 weighted", \
     rows("search", "wide") using 4:5 with linespoints linetype 3 title "5 x 5", \
     rows("search", "preset") using 4:5 with points linetype 6 title "presets", \
     labelled("search", "fast") using 4:5:3 with labels right offset -1.2, 0.4 @name, \
     labelled("search", "standard") using 4:5:3 with labels right offset -1.2, -0.6 @name, \
     labelled("search", "accurate") using 4:5:3 with labels right offset -1.2, -0.3 @name

unset label
set title "{/:Bold samples of a pixel, on bars drawn as surfaces}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel, with the tone image" textcolor "#606060"
set yrange [2e-3:1]
plot limit(x) with lines dashtype 3 linecolor "#808080" linewidth 1 notitle, \
     rows("samples", "thin") using 4:5 with linespoints linetype 3 title "bars half a pixel wide", \
     rows("samples", "thin") using 4:5:3 with labels left offset -2, 0.9 @note, \
     rows("samples", "wide") using 4:5 with linespoints linetype 1 title "bars 4 px wide", \
     rows("samples", "wide") using 4:5:3 with labels left offset -0.3, -1 @note, \
     rows("samples", "preset") using 4:5 with points linetype 6 title "presets", \
     labelled("samples", "fast") using 4:5:3 with labels right offset -1.2, 0.4 @name, \
     labelled("samples", "standard") using 4:5:3 with labels right offset -1.2, -0.6 @name, \
     labelled("samples", "accurate") using 4:5:3 with labels right offset 1, 1 @name

set title "{/:Bold kinds of blur, widths 4, 8, 16, 24}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel, blur alone" textcolor "#606060"
kinds = "exact separable recursive half kawase"
set logscale x
set xrange [*:*]
set yrange [5e-4:0.2]
plot limit(x) with lines dashtype 3 linecolor "#808080" linewidth 1 notitle, \
     for [i = 1:5] rows("blur", word(kinds, i)) using 4:5 with linespoints linetype i title word(kinds, i), \
     for [kind in "exact separable kawase"] rows("blur", kind) using 4:5:3 with labels left offset 0.7, 0.5 @note

set title "{/:Bold the same, moved by one pixel}" offset 0, -0.5 textcolor "#202020"
set ylabel "largest change of opacity, of 255" textcolor "#606060" offset 1, 0
set yrange [5e-3:500]
set ytics add ("none" 0.01)
plot for [i = 1:5] rows("moved", word(kinds, i)) using 4:5 with linespoints linetype i title word(kinds, i), \
     for [kind in "half kawase"] rows("moved", kind) using 4:5:3 with labels left offset 0.7, 0.5 @note
unset logscale x
set ytics autofreq

formats = "rg8 rg16 rg16f rg32f"
set title "{/:Bold formats of tones, contrast 1, .1, .03; widths 4 and 16}" offset 0, -0.5 textcolor "#202020"
set xlabel "ms by megapixel" textcolor "#606060"
set ylabel place_axis textcolor "#606060" offset 1, 0
set xrange [0:*]
set yrange [1e-3:1]
set key top left
plot limit(x) with lines dashtype 3 linecolor "#808080" linewidth 1 notitle, \
     for [i = 1:4] rows("storage", word(formats, i)) using 4:5 with linespoints linetype i title word(formats, i), \
     for [name in "rg8 rg16f"] rows("storage", name) using 4:5:3 with labels left offset 0.7, 0.4 @note

set title "{/:Bold beta: edges that are drawn, and what it costs}" offset 0, -0.5 textcolor "#202020"
set xlabel "beta" textcolor "#606060"
set ylabel "width drawn, by that of the line" textcolor "#606060" offset 1, 0
unset logscale y
set xrange [0:1]
set yrange [0:2.4]
set ytics nomirror
set y2range [0:4 * STATS_max] # below the rest
set y2tics nomirror textcolor "#606060"
set border 11
set y2label "ms by megapixel" textcolor "#606060" offset -1, 0
set key top right
plot for [i = 1:2] rows("beta", "edge ".word("1 0.3", i)) using 4:5 with linespoints linetype i title "edge of contrast ".word("1 .3", i), \
     for [i = 1:2] rows("beta", "paper ".word("1 0.3", i)) using 4:5 with lines linetype i linewidth 1 dashtype 2 notitle, \
     1 / 0 with lines linecolor "#808080" linewidth 1 dashtype 2 title "the paper's search", \
     rows("beta", "bar") using 4:5 with linespoints linetype 4 title "bar", \
     rows("beta", "ms") using 4:5 axes x1y2 with lines linetype 5 linewidth 1 title "time"
unset multiplot
