package org.robotui.rfic.recording.internal.time;

import java.util.List;
import org.robotui.api.port.Input;
import org.robotui.api.replay.StreamHistory;

/** All of a recording, with what there is in it. */
public interface SearchableHistory extends StreamHistory {
  /**
   * The streams that can be read.
   *
   * @return sorted by name
   */
  List<Input.Candidate> candidates();
}
