package org.robotui.gl.display;

import java.util.Optional;
import java.util.concurrent.Executor;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;

/** What a scene gives to a display. Safe for all threads. */
public interface DisplayContext {
  /**
   * Runs what may block; as {@code UicContext.background()}.
   *
   * @return takes tasks; interrupted at the end of the scene
   */
  Executor background();

  /**
   * The whole of a stream that is played from a recording. Worker thread of the scene.
   *
   * @param source a stream
   * @return what is read in the background; none of a live robot
   */
  default Optional<StreamHistory> history(SourceId source) {
    return Optional.empty();
  }

  /**
   * Asks for a tick soon, for example when a task in the background brought something.
   */
  void wake();

  /**
   * Sends a command of a display that is handled (feedback of markers, waypoints) through the arbiter.
   *
   * @param command one of the command types of the scene's ports
   * @return what became of it
   */
  CommandOutcome send(Data command);
}
