package org.robotui.roboframe.board;

/**
 * A value of a key.
 *
 * @param value the value
 * @param stampNanos when it was written, nanoseconds since the epoch by the clock of whoever wrote it
 * @param count how many were written of the key before it, by the same application
 * @param from the application that wrote it; empty where it is this one
 * @param <T> its type
 */
public record Posted<T>(T value, long stampNanos, long count, String from) {}
