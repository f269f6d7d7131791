package org.robotui.ui.layer;

/**
 * Where the plane touches the earth on which layers lie: x leads to the east, y to the north, in metres from here.
 *
 * @param latitude radians, north is positive
 * @param longitude radians, east is positive
 */
public record EarthOrigin(double latitude, double longitude) {}
