package org.robotui.ui.show;

import java.util.List;
import org.robotui.api.show.Subject;

/**
 * Ports, or fields of them, that the user drags.
 *
 * @param ruic name of the RUIC that they belong to
 * @param streams what is dragged, in the order of the list
 */
public record DraggedPorts(String ruic, List<Subject.Stream> streams) {
  /**
   * Copies the list.
   *
   * @param ruic name of the RUIC
   * @param streams what is dragged
   */
  public DraggedPorts {
    streams = List.copyOf(streams);
  }
}
