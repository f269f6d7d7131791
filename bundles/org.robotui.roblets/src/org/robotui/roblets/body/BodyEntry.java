package org.robotui.roblets.body;

import org.robotui.roblets.tree.BodyElement;

/**
 * A message in the bodymap.
 *
 * @param element what was said
 * @param receivedNanos when it came, {@link System#nanoTime()}
 * @param stampNanos when it was said by the clock of the roblet, nanoseconds since the epoch; 0 where not known
 * @param sequence counts what the roblet says
 */
public record BodyEntry(BodyElement element, long receivedNanos, long stampNanos, long sequence) {}
