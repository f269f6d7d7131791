package org.robotui.uic.status.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.ui.Health;

/**
 * What the view shows. There may be thousands of ports: ticks choose the lines, and the display thread paints what is
 * seen of them.
 *
 * @param rows the lines that fit the filter
 * @param trouble what is said in place of lines
 * @param note what stands at the right of the view's title
 * @param stoppedBy who latched the stop
 * @param connections whether connections are shown in place of ports
 */
record Page(List<StatusRow> rows, Optional<Trouble> trouble, String note, Optional<String> stoppedBy,
    boolean connections) {
  /**
   * Why there is nothing to list.
   *
   * @param health the dot
   * @param title a few words
   * @param sentence what would help
   */
  record Trouble(Health health, String title, String sentence) {}
}
