# One colour and dash an index, in the order of report.gp; seven colours, then again with other dashes.
colours = blue." ".vermilion." ".green." ".purple." ".orange." ".sky_blue." ".black
colour_of(i) = word(colours, 1 + (i - 1) % 7)
dash_of(i) = 1 + (i - 1) / 7 * 2
