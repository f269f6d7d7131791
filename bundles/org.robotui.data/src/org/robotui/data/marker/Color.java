package org.robotui.data.marker;

/**
 * A colour as robots send it, sRGB, not premultiplied. It may be anything a robot can send; who draws it brings it into
 * range.
 *
 * @param red 0 to 1
 * @param green 0 to 1
 * @param blue 0 to 1
 * @param alpha 0 invisible to 1 opaque
 */
public record Color(float red, float green, float blue, float alpha) {}
