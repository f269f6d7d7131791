package org.robotui.core.internal.config.model;

import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.layout.Arrangement;

/**
 * How a user arranged the views of one RUIC.
 *
 * @param arrangement as they lie now, where that is not as the configuration says
 * @param perspectives arrangements that have a name
 * @param perspective the name of the one that was chosen or kept last, where there is one
 */
public record KeptViews(Optional<Hand> arrangement, Map<String, Arrangement> perspectives,
    Optional<String> perspective) {
  /** Nothing is arranged. */
  public static final KeptViews NONE = new KeptViews(Optional.empty(), Map.of(), Optional.empty());

  /**
   * An arrangement by hand.
   *
   * @param arrangement where the views lie
   * @param known all views that there were when it was made: one that is not among them is new, one that is and lies
   * nowhere was closed
   * @param insteadOf marks the layout in the file that it took the place of; empty where the file has none
   */
  public record Hand(Arrangement arrangement, Set<String> known, String insteadOf) {
    /**
     * Copies the set.
     *
     * @param arrangement where the views lie
     * @param known all views that there were
     * @param insteadOf marks the layout in the file
     */
    public Hand {
      known = new LinkedHashSet<>(known);
    }
  }

  /**
   * Copies the map.
   *
   * @param arrangement as they lie now
   * @param perspectives arrangements that have a name
   * @param perspective the name of the last one
   */
  public KeptViews {
    perspectives = Map.copyOf(perspectives);
  }
}
