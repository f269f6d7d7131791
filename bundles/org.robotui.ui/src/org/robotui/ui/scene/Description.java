package org.robotui.ui.scene;

/**
 * What lies at a point of a scene.
 *
 * @param text a line or two for users: what it is, its value
 * @param distance how far it is from the point, metres, 0 where the point is on it
 */
public record Description(String text, double distance) {}
