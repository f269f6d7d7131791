package org.robotui.entity.image;

/**
 * What the colours of a picture mean.
 *
 * @param map the colours
 * @param reversed whether the smallest number has the last colour
 * @param span the numbers at the ends of the map
 * @param follows whether the range follows what the pictures hold
 * @param gaps whether there may be pixels without a number, painted as {@link ColorMap#nothing}
 * @param unit of the numbers, empty where none is known
 */
public record Legend(ColorMap map, boolean reversed, Span span, boolean follows, boolean gaps, String unit) {}
