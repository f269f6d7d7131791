package org.robotui.guard;

/**
 * How a guard is doing.
 *
 * @param pid of its process, 0 where none runs
 * @param starts how often it was started
 * @param overflows how many connections it closed because what came was taken too slowly
 * @param silences how often it found this process silent
 */
public record GuardState(long pid, long starts, long overflows, long silences) {}
