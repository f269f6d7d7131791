package org.robotui.recording.internal.rosbag2;

/**
 * The rows of a chunk: those of some pages, without the first ones of the first page and the last ones of the last.
 *
 * @param pages numbers of pages, in order
 * @param first the first row of the first page
 * @param end behind the last row of the last page
 */
record RowRange(int[] pages, int first, int end) {}
