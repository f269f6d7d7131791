package org.robotui.api.script;

import java.util.List;
import java.util.concurrent.CompletionStage;

/**
 * Scripts that share their variables, and the right to command: what one takes control of, the next may move. One runs
 * at a time. Safe for all threads; never blocks.
 */
public interface ScriptSession extends AutoCloseable {
  /**
   * Runs a script on a thread of its own, after those that were given before.
   *
   * @param source the script
   * @return how it ended; never completes exceptionally, and completes on the thread of the script
   */
  CompletionStage<ScriptOutcome> run(ScriptSource source);

  /**
   * Stops the script that runs and forgets those that wait. What it moves is stopped at once.
   *
   * @param reason a sentence for users
   */
  void stop(String reason);

  /**
   * What could stand at the end of a line that is being typed: functions, variables of the session, and, within quotes,
   * names of ports and robot UIs.
   *
   * @param line up to where the user types
   * @return whole words in place of the last one, sorted; at most 100
   */
  Completion complete(String line);

  /** Ends: what was taken control of is given back, what it moves is stopped. */
  @Override
  void close();

  /**
   * What could stand at the end of a line.
   *
   * @param start where in the line the last word begins, from 0
   * @param words what may take its place
   */
  record Completion(int start, List<String> words) {
    /**
     * Copies the list.
     *
     * @param start where the last word begins
     * @param words what may take its place
     */
    public Completion {
      words = List.copyOf(words);
    }
  }
}
