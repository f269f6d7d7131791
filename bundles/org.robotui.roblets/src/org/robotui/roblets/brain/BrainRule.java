package org.robotui.roblets.brain;

import org.robotui.roblets.body.BodyChange;
import org.robotui.roblets.tree.BodyPath;

/**
 * What a brain does when something comes into its bodymap.
 *
 * @param name for logs
 * @param when what has to come: a path that begins with roblets
 * @param action what to do
 */
public record BrainRule(String name, BodyPath when, Action action) {
  /** Does something. */
  @FunctionalInterface
  public interface Action {
    /**
     * Something came. Called on the thread of rules, one after another; what it throws is logged, and the next rule
     * goes on.
     *
     * @param change what came, with the whole body
     * @param brain to say something to roblets
     */
    void act(BodyChange change, Brain brain);
  }

  /**
   * A rule.
   *
   * @param name for logs
   * @param when a path, as {@link BodyPath#parse} takes it
   * @param action what to do
   * @return the rule
   */
  public static BrainRule when(String name, String when, Action action) {
    return new BrainRule(name, BodyPath.parse(when), action);
  }
}
