package org.robotui.player.interfaces;

/**
 * The gains of a PID controller.
 *
 * @param proportional of the error
 * @param integral of its sum
 * @param derivative of its change
 */
public record Gains(float proportional, float integral, float derivative) {}
