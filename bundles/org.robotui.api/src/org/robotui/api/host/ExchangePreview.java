package org.robotui.api.host;

import java.util.List;
import org.robotui.api.link.LinkState;

/**
 * What would become of a RUIC if a robot interface took the place of another.
 *
 * @param verdict whether it can be exchanged
 * @param sentence why, for users
 * @param link the link of the interface that is tried
 * @param lines every port of the views
 * @param missing a sentence per used connection that would be lost; they are why it is incomplete
 * @param notes what else the user should know, such as a stop call that the new one does not have
 */
public record ExchangePreview(
    Verdict verdict, String sentence, LinkState link, List<Line> lines, List<String> missing, List<String> notes) {
  /** Whether it can be exchanged. */
  public enum Verdict {
    /** The robot has not said enough yet. */
    PENDING,
    /** All that is used would be covered. */
    READY,
    /** Used connections would be lost. */
    INCOMPLETE,
    /** It cannot be started. */
    FAILED
  }

  /**
   * One port of a view.
   *
   * @param now how it is connected
   * @param then how it would be
   * @param concerned whether the exchanged interface is among what it is connected to, now or then
   * @param lost whether it is used, and nothing of the new interface fits
   */
  public record Line(Match now, Match then, boolean concerned, boolean lost) {}

  /**
   * Copies the lists.
   *
   * @param verdict whether it can be exchanged
   * @param sentence why
   * @param link the link of the interface that is tried
   * @param lines every port of the views
   * @param missing a sentence per used connection that would be lost
   * @param notes what else the user should know
   */
  public ExchangePreview {
    lines = List.copyOf(lines);
    missing = List.copyOf(missing);
    notes = List.copyOf(notes);
  }
}
