package org.robotui.api.frame;

/**
 * A transform that was not taken, because it cannot be: it closes a loop, has no rotation, is one too many.
 *
 * @param reason a sentence that names both frames
 * @param authority who sent it
 * @param count how often
 * @param receivedNanos {@link System#nanoTime()} when it came last
 */
public record FrameRefusal(String reason, String authority, long count, long receivedNanos) {}
