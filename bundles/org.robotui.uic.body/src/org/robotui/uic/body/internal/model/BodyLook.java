package org.robotui.uic.body.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.InputState;

/**
 * What is shown next; immutable.
 *
 * @param lines of the tree that are seen
 * @param parts how many parts there are
 * @param detail the history of the selected line
 * @param state of the input
 * @param searched whether words were searched
 */
public record BodyLook(List<BodyLine> lines, int parts, Optional<BodyPast> detail, InputState state,
    boolean searched) {
  /** Copies the list. */
  public BodyLook {
    lines = List.copyOf(lines);
  }
}
