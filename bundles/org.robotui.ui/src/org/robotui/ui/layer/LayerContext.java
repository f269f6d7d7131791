package org.robotui.ui.layer;

import java.util.Optional;
import java.util.concurrent.Executor;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;

/** What a view gives to a layer. Safe for all threads. */
public interface LayerContext {
  /**
   * Runs what may block; what it brings is taken with the next tick.
   *
   * @return takes tasks; interrupted at the end of the view
   */
  Executor background();

  /**
   * The whole of a stream that is played from a recording. Worker thread of the view.
   *
   * @param source a stream
   * @return what is read in the background; none of a live robot
   */
  default Optional<StreamHistory> history(SourceId source) {
    return Optional.empty();
  }
}
