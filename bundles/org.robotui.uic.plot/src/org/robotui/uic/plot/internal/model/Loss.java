package org.robotui.uic.plot.internal.model;

/**
 * Values that were lost between two that came, for example while the view was not selected.
 *
 * @param from time of the last before
 * @param to time of the first after
 * @param count how many
 */
public record Loss(long from, long to, long count) {}
