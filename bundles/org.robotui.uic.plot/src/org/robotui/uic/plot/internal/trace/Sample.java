package org.robotui.uic.plot.internal.trace;

/**
 * One sample.
 *
 * @param time nanoseconds
 * @param value a number
 */
public record Sample(long time, double value) {}
