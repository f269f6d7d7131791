package org.robotui.uic.log.internal.model;

/**
 * How much of the log is of one node.
 *
 * @param origin the node
 * @param count entries that are kept
 */
public record OriginCount(String origin, int count) {}
