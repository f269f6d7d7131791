package org.robotui.api.show;

import java.util.List;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;

/** Something of a robot that a user points at in one view and may want to see in another. It belongs to one RUIC. */
public sealed interface Subject {
  /**
   * A stream, or some of the fields of its values.
   *
   * @param port a port of a robot interface
   * @param fields paths as {@link org.robotui.data.record.FieldPath} reads them, for example {@code linear.x}; empty
   * for the whole value
   */
  record Stream(SourceId port, List<String> fields) implements Subject {
    /**
     * Copies the list.
     *
     * @param port a port of a robot interface
     * @param fields paths, empty for the whole value
     */
    public Stream {
      fields = List.copyOf(fields);
    }

    /**
     * All of a stream.
     *
     * @param port a port of a robot interface
     * @return the subject
     */
    public static Stream of(SourceId port) {
      return new Stream(port, List.of());
    }
  }

  /**
   * A coordinate frame.
   *
   * @param frame with the robot that it belongs to
   */
  record Frame(FrameId frame) implements Subject {}

  /**
   * A program that runs on a robot.
   *
   * @param name the robot's name of it
   */
  record Node(String name) implements Subject {}
}
