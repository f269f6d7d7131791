package org.robotui.player.interfaces;

/**
 * A colour, each part 0 to 255.
 *
 * @param alpha 255 is opaque
 * @param red its red part
 * @param green its green part
 * @param blue its blue part
 */
public record Color(int alpha, int red, int green, int blue) {}
