package org.robotui.ui.ask;

import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.ui.Health;

/** Asks a robot: the one thing in which views that ask differ. */
@FunctionalInterface
public interface Asker {
  /**
   * Begins to ask. Called on the display thread; must not block. Everything that becomes of it is reported, also that
   * it cannot be asked.
   *
   * @param entry what to ask
   * @param values what was filled in
   * @param report where to report
   * @return gives up what was begun
   */
  Runnable ask(Catalogue.Entry entry, Map<String, Object> values, Report report);

  /** Is told what becomes of it, on any thread. */
  interface Report {
    /**
     * It goes on.
     *
     * @param words a sentence
     */
    void progress(String words);

    /**
     * The robot says something on its way.
     *
     * @param record what it says
     */
    void feedback(DynamicRecord record);

    /**
     * It has ended.
     *
     * @param health how well
     * @param words a sentence
     * @param result what came back
     */
    void end(Health health, String words, Optional<DynamicRecord> result);
  }
}
