package org.robotui.player.interfaces;

/**
 * Bounds of a speed profile.
 *
 * @param speed the highest speed, metres per second
 * @param acceleration the highest acceleration, metres per second squared
 */
public record Profile(float speed, float acceleration) {}
